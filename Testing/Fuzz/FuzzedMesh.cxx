// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedMesh.h"

#include "Solids.h"

#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

namespace arris
{
namespace testing
{
namespace
{
using Cell = std::vector<vtkIdType>;

/// What the damage is done to.
struct Draft
{
  std::vector<Point3> Points;
  std::vector<Cell> Polys;
  std::vector<Cell> Strips;
  std::vector<Cell> Lines;

  vtkIdType Count() const { return static_cast<vtkIdType>(this->Points.size()); }
};

Draft DraftOf(vtkPolyData* mesh)
{
  Draft draft;
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    draft.Points.emplace_back();
    mesh->GetPoint(v, draft.Points.back().data());
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfPolys(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, ids);
    draft.Polys.emplace_back(ids->begin(), ids->end());
  }
  return draft;
}

/// A square of points in a plane, or a roof of two.
Draft Sheet(int side, double slope)
{
  Draft draft;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      draft.Points.emplace_back(x, y, -slope * std::abs(x - side / 2));
    }
  }
  for (int y = 0; y + 1 < side; ++y)
  {
    for (int x = 0; x + 1 < side; ++x)
    {
      const vtkIdType a = y * side + x;
      draft.Polys.push_back({ a, a + 1, a + side + 1 });
      draft.Polys.push_back({ a, a + side + 1, a + side });
    }
  }
  return draft;
}

/// A cone of `count` triangles around one vertex.
Draft Fan(int count)
{
  Draft draft;
  draft.Points.emplace_back(0.0, 0.0, 1.0);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    draft.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    draft.Polys.push_back({ 0, i + 1, (i + 1) % count + 1 });
  }
  return draft;
}

Draft SingleTriangles(int count)
{
  Draft draft;
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType a = draft.Count();
    draft.Points.emplace_back(i, 0.0, 0.0);
    draft.Points.emplace_back(i + 0.9, 0.0, 0.1 * i);
    draft.Points.emplace_back(i, 0.9, 0.0);
    draft.Polys.push_back({ a, a + 1, a + 2 });
  }
  return draft;
}

const Draft& SoundMesh(int number)
{
  static const Draft Meshes[] = { DraftOf(Contour(BoxSolid(), 10)),
    DraftOf(Contour(BracketSolid(), 12)), DraftOf(Contour(CylinderSolid(), 10)), Sheet(8, 0.0),
    Sheet(12, 1.0), Fan(5), Fan(60), SingleTriangles(6), Draft() };
  return Meshes[number % std::size(Meshes)];
}
constexpr int SoundMeshes = 9;

/// Mostly a point that is there.
vtkIdType AnyId(Decisions& decisions, const Draft& draft)
{
  constexpr vtkIdType Strange[] = { -1, 1 << 30, std::numeric_limits<vtkIdType>::max() };
  const int kind = decisions.Choice(64);
  return kind == 63 ? Strange[decisions.Choice(3)]
    : kind == 62    ? draft.Count()
                    : decisions.Id(draft.Count());
}

Cell AnyCell(Decisions& decisions, const Draft& draft, int mostPoints)
{
  Cell cell(decisions.Choice(mostPoints + 1));
  for (vtkIdType& id : cell)
  {
    id = AnyId(decisions, draft);
  }
  return cell;
}

void MovePoints(Decisions& decisions, Draft& draft)
{
  if (draft.Points.empty())
  {
    draft.Points.emplace_back(Point3::Zero());
  }
  Point3& point = draft.Points[decisions.Id(draft.Count())];
  switch (decisions.Choice(6))
  {
    case 0:
      point = draft.Points[decisions.Id(draft.Count())];
      break;
    case 1:
      point[decisions.Choice(3)] = decisions.Number();
      break;
    case 2:
      point +=
        0.02 * Point3(decisions.Byte() - 128, decisions.Byte() - 128, decisions.Byte() - 128);
      break;
    case 3:
      point = Point3(decisions.Number(), decisions.Number(), decisions.Number());
      break;
    case 4: // all in one plane
    {
      const int axis = decisions.Choice(3);
      for (Point3& p : draft.Points)
      {
        p[axis] = 0.0;
      }
      break;
    }
    default: // in another unit, far away
    {
      const double unit = decisions.Number();
      const double away = decisions.Number();
      for (Point3& p : draft.Points)
      {
        p = unit * p + Point3::Constant(away);
      }
    }
  }
}

void ChangeTriangles(Decisions& decisions, Draft& draft)
{
  if (draft.Polys.empty())
  {
    draft.Polys.push_back({ 0, 1, 2 });
  }
  const std::int64_t number = decisions.Id(static_cast<std::int64_t>(draft.Polys.size()));
  Cell& cell = draft.Polys[number];
  switch (decisions.Choice(6))
  {
    case 0:
      draft.Polys.emplace_back(cell);
      break;
    case 1:
      std::reverse(cell.begin(), cell.end());
      break;
    case 2:
      draft.Polys.erase(draft.Polys.begin() + number);
      break;
    case 3:
      if (!cell.empty())
      {
        cell[decisions.Id(static_cast<std::int64_t>(cell.size()))] = AnyId(decisions, draft);
      }
      break;
    case 4:
      draft.Polys.push_back(
        { AnyId(decisions, draft), AnyId(decisions, draft), AnyId(decisions, draft) });
      break;
    default: // a second skin, of the same points or its own
    {
      const vtkIdType shift = decisions.Yes() ? 0 : draft.Count();
      if (shift > 0)
      {
        const std::vector<Point3> copies = draft.Points;
        draft.Points.insert(draft.Points.end(), copies.begin(), copies.end());
      }
      const std::size_t count = std::min<std::size_t>(draft.Polys.size(), 300);
      for (std::size_t i = 0; i < count; ++i)
      {
        Cell copy = draft.Polys[i];
        for (vtkIdType& id : copy)
        {
          id = id >= 0 && id < shift ? id + shift : id;
        }
        draft.Polys.push_back(copy);
      }
    }
  }
}

constexpr std::size_t MostPoints = 3000; // so that one case takes no more than seconds

void Damage(Decisions& decisions, Draft& draft)
{
  switch (decisions.Choice(8))
  {
    case 0:
    case 1:
    case 2:
      MovePoints(decisions, draft);
      break;
    case 3:
    case 4:
    case 5:
      if (draft.Points.size() < MostPoints && draft.Polys.size() < 2 * MostPoints)
      {
        ChangeTriangles(decisions, draft);
      }
      break;
    case 6:
      draft.Polys.push_back(AnyCell(decisions, draft, 9));
      break;
    default:
      (decisions.Yes() ? draft.Strips : draft.Lines).push_back(AnyCell(decisions, draft, 9));
  }
}

vtkSmartPointer<vtkCellArray> CellsOf(const std::vector<Cell>& draft)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Cell& cell : draft)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return cells;
}

vtkSmartPointer<vtkAbstractArray> ArrayOfKind(int kind)
{
  switch (kind)
  {
    case 0:
      return vtkSmartPointer<vtkIntArray>::New();
    case 1:
      return vtkSmartPointer<vtkUnsignedCharArray>::New();
    case 2:
      return vtkSmartPointer<vtkStringArray>::New();
    case 3:
      return vtkSmartPointer<vtkBitArray>::New();
    default:
      return vtkSmartPointer<vtkDoubleArray>::New();
  }
}

void AddArray(Decisions& decisions, vtkPolyData* mesh)
{
  constexpr const char* Names[] = { "SharpRegion", "USSOD", "ThinningRound", "NormalDeviation",
    "SkeletonRole", "Window", "SharpAngle", "Lambda", "PatchId", "SurfaceId", "EdgeAngle",
    "Outcome", "Displacement", "Normals", "vtkGhostType" };
  const char* name = Names[decisions.Choice(static_cast<int>(std::size(Names)))];
  vtkFieldData* const places[] = { mesh->GetPointData(), mesh->GetPointData(), mesh->GetCellData(),
    mesh->GetFieldData() };
  const int place = decisions.Choice(4);
  const vtkIdType counts[] = { mesh->GetNumberOfPoints(), mesh->GetNumberOfPoints(),
    mesh->GetNumberOfCells(), 1 };
  const vtkSmartPointer<vtkAbstractArray> array = ArrayOfKind(decisions.Choice(8));
  array->SetName(name);
  array->SetNumberOfComponents(decisions.Choice(16) == 15 ? 1 + decisions.Choice(4) : 1);
  const int size = decisions.Choice(32); // mostly the right one
  array->SetNumberOfTuples(size == 31 ? decisions.Byte() : counts[place]);
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (numbers != nullptr)
  {
    numbers->Fill(0.0);
    const double common = decisions.Choice(8) - 1.0;
    for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
    {
      numbers->SetComponent(i, 0, i % 3 == 0 ? common : -1.0);
    }
    for (int k = decisions.Choice(8); k > 0 && numbers->GetNumberOfTuples() > 0; --k)
    {
      numbers->SetComponent(decisions.Id(numbers->GetNumberOfTuples()), 0,
        array->IsA("vtkDoubleArray") ? decisions.Number() : decisions.Byte());
    }
  }
  places[place]->AddArray(array);
}
}

vtkSmartPointer<vtkPolyData> FuzzedMesh(Decisions& decisions)
{
  Draft draft = SoundMesh(decisions.Choice(SoundMeshes));
  const bool single = decisions.Yes();
  const int arrays = decisions.Choice(4);
  constexpr int MostDamage = 30;
  const int damage = decisions.Choice(MostDamage);
  for (int i = 0; i < damage; ++i)
  {
    Damage(decisions, draft);
  }

  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(draft.Count());
  for (vtkIdType v = 0; v < draft.Count(); ++v)
  {
    Point3 p = draft.Points[v];
    if (single) // a double out of a float's range may not be turned into one
    {
      constexpr double Most = std::numeric_limits<float>::max();
      p = p.unaryExpr([=](double c) { return std::isfinite(c) ? std::clamp(c, -Most, Most) : c; });
    }
    points->SetPoint(v, p.data());
  }
  if (draft.Count() > 0)
  {
    mesh->SetPoints(points);
  }
  mesh->SetPolys(CellsOf(draft.Polys));
  if (!draft.Strips.empty())
  {
    mesh->SetStrips(CellsOf(draft.Strips));
  }
  if (!draft.Lines.empty())
  {
    mesh->SetLines(CellsOf(draft.Lines));
  }
  for (int i = 0; i < arrays; ++i)
  {
    AddArray(decisions, mesh);
  }
  return mesh;
}
}
}
