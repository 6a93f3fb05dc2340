// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Selections.h"

#include "Core/Types.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSignedCharArray.h>
#include <vtkStaticCellLocator.h>
#include <vtkStaticPointLocator.h>
#include <vtkVariant.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace arris
{
namespace
{
/// One node of a selection, the mesh it selects from, and where to mark what it selects.
struct Node
{
  vtkSelectionNode* Selection;
  vtkPolyData* Mesh;
  bool AreCells;
  vtkSignedCharArray* Inside;

  vtkDataSetAttributes* Attributes() const
  {
    return this->AreCells ? static_cast<vtkDataSetAttributes*>(this->Mesh->GetCellData())
                          : static_cast<vtkDataSetAttributes*>(this->Mesh->GetPointData());
  }
  void Mark(vtkIdType id) const { this->Inside->SetValue(id, 1); }
};

std::string MarkIndices(const Node& node, vtkDataArray* list)
{
  for (vtkIdType i = 0; i < list->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<vtkIdType>(list->GetComponent(i, 0));
    if (id < 0 || id >= node.Inside->GetNumberOfTuples())
    {
      return std::string("it names ") + (node.AreCells ? "cell " : "point ") + std::to_string(id) +
        ", which the mesh does not have";
    }
    node.Mark(id);
  }
  return {};
}

std::string MarkValues(const Node& node, vtkAbstractArray* list, vtkAbstractArray* values)
{
  std::set<vtkVariant, vtkVariantLessThan> wanted;
  for (vtkIdType i = 0; i < list->GetNumberOfValues(); ++i)
  {
    wanted.insert(list->GetVariantValue(i));
  }
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    if (wanted.count(values->GetVariantValue(id * values->GetNumberOfComponents())) > 0)
    {
      node.Mark(id);
    }
  }
  return {};
}

/// `list` holds pairs of a lower and an upper value.
std::string MarkThresholds(const Node& node, vtkDataArray* list, vtkDataArray* values)
{
  vtkInformation* properties = node.Selection->GetProperties();
  const int component = properties->Has(vtkSelectionNode::COMPONENT_NUMBER())
    ? std::clamp(properties->Get(vtkSelectionNode::COMPONENT_NUMBER()), 0,
        values->GetNumberOfComponents() - 1)
    : 0;
  const auto bound = [list](vtkIdType i)
  {
    const int width = list->GetNumberOfComponents();
    return list->GetComponent(i / width, static_cast<int>(i % width));
  };
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    const double value = values->GetComponent(id, component);
    for (vtkIdType i = 0; i + 1 < list->GetNumberOfValues(); i += 2)
    {
      if (bound(i) <= value && value <= bound(i + 1))
      {
        node.Mark(id);
      }
    }
  }
  return {};
}

std::string MarkNearest(const Node& node, vtkDataArray* list)
{
  vtkNew<vtkStaticCellLocator> cells;
  vtkNew<vtkStaticPointLocator> points;
  if (node.AreCells)
  {
    cells->SetDataSet(node.Mesh);
    cells->BuildLocator();
  }
  else
  {
    points->SetDataSet(node.Mesh);
    points->BuildLocator();
  }
  for (vtkIdType i = 0; i < list->GetNumberOfTuples(); ++i)
  {
    double position[3];
    list->GetTuple(i, position);
    vtkIdType id = -1;
    if (node.AreCells)
    {
      double closest[3];
      double distance2 = 0.0;
      int subId = 0;
      cells->FindClosestPoint(position, closest, id, subId, distance2);
    }
    else
    {
      id = points->FindClosestPoint(position);
    }
    if (id >= 0)
    {
      node.Mark(id);
    }
  }
  return {};
}

/// The six sides of a frustum, as VTK lists its eight corners: left or right counts 4, bottom or
/// top 2, near or far 1.
class Frustum
{
public:
  using Corners = Eigen::Matrix<double, 3, 8>;

  explicit Frustum(const Corners& corners)
  {
    const Vec3 center = corners.rowwise().mean();
    constexpr int Faces[6][4] = { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
      { 0, 2, 6, 4 }, { 1, 3, 7, 5 } };
    for (int i = 0; i < 6; ++i)
    {
      const auto corner = [&](int k) -> Vec3 { return corners.col(Faces[i][k]); };
      // By the diagonals, which a side that ends in one point still has.
      this->Sides[i] = { corner(0), (corner(2) - corner(0)).cross(corner(3) - corner(1)) };
      if (this->Sides[i].Height(center) < 0.0)
      {
        this->Sides[i].Normal *= -1.0; // so that inside is where all heights are positive
      }
    }
  }

  bool Holds(const Vec3& point) const
  {
    return std::all_of(this->Sides.begin(), this->Sides.end(),
      [&](const Plane& side) { return side.Height(point) >= 0.0; });
  }

private:
  struct Plane
  {
    Vec3 Point = Vec3::Zero();
    Vec3 Normal = Vec3::Zero(); ///< of any length

    double Height(const Vec3& point) const { return this->Normal.dot(point - this->Point); }
  };

  std::array<Plane, 6> Sides;
};

/// Whether the corners lie in one plane, or do but for the rounding of their coordinates: sides of
/// such a frustum have no inside.
bool AreFlat(const Frustum::Corners& corners, double rounding)
{
  const Frustum::Corners fromCenter = corners.colwise() - corners.rowwise().mean();
  // The pivots go from the longest direction to that across the best plane.
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 8, 3>> directions(fromCenter.transpose());
  const double width = std::abs(directions.matrixQR()(2, 2));
  return width <= rounding * corners.cwiseAbs().maxCoeff();
}

std::string MarkFrustum(const Node& node, vtkDataArray* list)
{
  if (list->GetNumberOfTuples() != 8 || list->GetNumberOfComponents() < 3)
  {
    return "its frustum does not have eight corners";
  }
  Frustum::Corners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.col(i) << list->GetComponent(i, 0), list->GetComponent(i, 1), list->GetComponent(i, 2);
  }
  constexpr double Roundings = 16.0; // more than eight corners and their mean can add up to
  const double rounding = Roundings *
    (list->GetDataType() == VTK_FLOAT ? std::numeric_limits<float>::epsilon()
                                      : std::numeric_limits<double>::epsilon());
  if (!corners.allFinite() || AreFlat(corners, rounding))
  {
    return "its frustum has no width";
  }
  const Frustum frustum(corners);
  const auto holds = [&](vtkIdType point)
  {
    double position[3];
    node.Mesh->GetPoint(point, position);
    return frustum.Holds(Vec3(position));
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType id = 0; id < node.Inside->GetNumberOfTuples(); ++id)
  {
    bool inside = false;
    if (node.AreCells)
    {
      node.Mesh->GetCellPoints(id, ids);
      inside = std::any_of(ids->begin(), ids->end(), holds);
    }
    else
    {
      inside = holds(id);
    }
    if (inside)
    {
      node.Mark(id);
    }
  }
  return {};
}

/// Those kinds that compare a list with an array of the mesh.
std::string MarkByArray(const Node& node, vtkAbstractArray* list)
{
  vtkDataSetAttributes* attributes = node.Attributes();
  const int kind = node.Selection->GetContentType();
  vtkAbstractArray* values = kind == vtkSelectionNode::GLOBALIDS ? attributes->GetGlobalIds()
    : kind == vtkSelectionNode::PEDIGREEIDS                      ? attributes->GetPedigreeIds()
    : list->GetName() != nullptr ? attributes->GetAbstractArray(list->GetName())
                                 : nullptr;
  if (values == nullptr)
  {
    return "the mesh does not have the array that it is about";
  }
  if (kind != vtkSelectionNode::THRESHOLDS)
  {
    return MarkValues(node, list, values);
  }
  vtkDataArray* bounds = vtkDataArray::SafeDownCast(list);
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(values);
  return bounds != nullptr && numbers != nullptr ? MarkThresholds(node, bounds, numbers)
                                                 : "thresholds need numbers";
}

/// Marks what the node selects; what is wrong with it, or nothing.
std::string Mark(const Node& node)
{
  vtkAbstractArray* list = node.Selection->GetSelectionList();
  if (list == nullptr)
  {
    return {}; // selects nothing
  }
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(list);
  switch (node.Selection->GetContentType())
  {
    case vtkSelectionNode::INDICES:
      return numbers != nullptr ? MarkIndices(node, numbers) : "its indices are no numbers";
    case vtkSelectionNode::LOCATIONS:
      return numbers != nullptr && numbers->GetNumberOfComponents() == 3
        ? MarkNearest(node, numbers)
        : "its locations do not have three coordinates";
    case vtkSelectionNode::FRUSTUM:
      return numbers != nullptr ? MarkFrustum(node, numbers) : "its frustum is no numbers";
    case vtkSelectionNode::GLOBALIDS:
    case vtkSelectionNode::PEDIGREEIDS:
    case vtkSelectionNode::VALUES:
    case vtkSelectionNode::THRESHOLDS:
      return MarkByArray(node, list);
    default:
      return std::string("its kind, ") +
        vtkSelectionNode::GetContentTypeAsString(node.Selection->GetContentType()) +
        ", cannot be read here: select by ids, values, a frustum or locations";
  }
}

void Invert(vtkSignedCharArray* inside)
{
  for (vtkIdType id = 0; id < inside->GetNumberOfTuples(); ++id)
  {
    inside->SetValue(id, inside->GetValue(id) == 0 ? 1 : 0);
  }
}
}

std::string EvaluateSelection(
  vtkSelection* selection, vtkPolyData* mesh, SelectedElements& selected)
{
  std::vector<vtkSmartPointer<vtkSignedCharArray>> insides;
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    const bool cells = node->GetFieldType() == vtkSelectionNode::CELL;
    if ((!cells && node->GetFieldType() != vtkSelectionNode::POINT) ||
      (i > 0 && cells != selected.AreCells))
    {
      return "it must select either points or cells";
    }
    selected.AreCells = cells;
    auto inside = vtkSmartPointer<vtkSignedCharArray>::New();
    inside->SetNumberOfValues(cells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints());
    inside->FillValue(0);
    std::string problem = Mark({ node, mesh, cells, inside });
    if (!problem.empty())
    {
      return problem;
    }
    vtkInformation* properties = node->GetProperties();
    if (properties->Has(vtkSelectionNode::INVERSE()) &&
      properties->Get(vtkSelectionNode::INVERSE()) != 0)
    {
      Invert(inside);
    }
    insides.push_back(inside);
  }

  std::vector<vtkSignedCharArray*> values(insides.begin(), insides.end());
  const auto result = selection->Evaluate(values.data(), static_cast<unsigned int>(values.size()));
  for (vtkIdType id = 0; result != nullptr && id < result->GetNumberOfTuples(); ++id)
  {
    if (result->GetValue(id) != 0)
    {
      selected.Ids.push_back(id);
    }
  }
  return {};
}
}
