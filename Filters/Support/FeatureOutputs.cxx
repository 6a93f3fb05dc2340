// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureOutputs.h"

#include "Arrays.h"
#include "Core/Features/CurveProperties.h"
#include "Core/Features/Resampling.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

namespace arris
{
namespace
{
template <typename ArrayType>
vtkSmartPointer<ArrayType> NewArray(const char* name, vtkFieldData* owner, int components = 1)
{
  const auto values = vtkSmartPointer<ArrayType>::New();
  values->SetName(name);
  values->SetNumberOfComponents(components);
  owner->AddArray(values);
  return values;
}

/// Writes the points of curves one after the other, with their arrays.
class CurvePoints
{
public:
  CurvePoints(vtkPolyData* lines, vtkIdType count, vtkPolyData* mesh)
    : From(mesh)
    , To(lines)
  {
    this->Positions->SetDataType(mesh->GetPoints()->GetDataType());
    this->Positions->SetNumberOfPoints(count);
    lines->SetPoints(this->Positions);
    lines->GetPointData()->CopyAllOn();
    lines->GetPointData()->InterpolateAllocate(mesh->GetPointData(), count);
    lines->GetPointData()->SetNumberOfTuples(count);
  }

  /// Adds the arrays of its own, once those of the mesh are there with all their values.
  void Finish()
  {
    vtkPointData* data = this->To->GetPointData();
    const auto angles = NewArray<vtkDoubleArray>(array::DihedralAngle, data);
    const auto tangents = NewArray<vtkDoubleArray>(array::Tangent, data, 3);
    const auto ids = NewArray<vtkIdTypeArray>(array::MeshPointId, data);
    for (const Own& own : this->OwnValues)
    {
      angles->InsertNextValue(own.Angle);
      tangents->InsertNextTuple(own.Tangent.data());
      ids->InsertNextValue(own.MeshPoint);
    }
  }

  void Add(const Curve& curve, const std::vector<CurvePoint>& samples,
    const std::vector<Vec3>& tangents, const std::vector<double>& angles)
  {
    for (const CurvePoint& sample : samples)
    {
      const std::size_t next = (sample.At + 1) % tangents.size();
      const double share = sample.Share;
      const Vec3 tangent = (1.0 - share) * tangents[sample.At] + share * tangents[next];
      this->OwnValues.push_back({ (1.0 - share) * angles[sample.At] + share * angles[next],
        tangent.normalized(), share == 0.0 ? curve[sample.At] : NoIndex });
      const auto to = static_cast<vtkIdType>(this->OwnValues.size()) - 1;
      Vec3 here;
      this->From->GetPoint(curve[sample.At], here.data());
      if (share == 0.0)
      {
        this->To->GetPointData()->CopyData(this->From->GetPointData(), curve[sample.At], to);
      }
      else
      {
        Vec3 there;
        this->From->GetPoint(curve[sample.At + 1], there.data());
        here += share * (there - here);
        this->To->GetPointData()->InterpolateEdge(
          this->From->GetPointData(), to, curve[sample.At], curve[sample.At + 1], share);
      }
      this->Positions->SetPoint(to, here.data());
    }
  }

private:
  struct Own
  {
    double Angle;
    Vec3 Tangent;
    Index MeshPoint;
  };

  vtkPolyData* From;
  vtkPolyData* To;
  vtkNew<vtkPoints> Positions;
  std::vector<Own> OwnValues;
};

void AddCurveProperties(vtkPolyData* lines, const std::vector<CurveProperties>& curves)
{
  vtkCellData* data = lines->GetCellData();
  const auto ids = NewArray<vtkIntArray>(array::CurveId, data);
  const auto angles = NewArray<vtkDoubleArray>(array::DihedralAngle, data);
  const auto lengths = NewArray<vtkDoubleArray>(array::CurveLength, data);
  const auto least = NewArray<vtkDoubleArray>(array::MinimumDihedralAngle, data);
  const auto largest = NewArray<vtkDoubleArray>(array::MaximumDihedralAngle, data);
  const auto kinds = NewArray<vtkUnsignedCharArray>(array::CurveKind, data);
  const auto closed = NewArray<vtkUnsignedCharArray>(array::Closed, data);
  const auto left = NewArray<vtkIntArray>(array::LeftSurfaceId, data);
  const auto right = NewArray<vtkIntArray>(array::RightSurfaceId, data);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    ids->InsertNextValue(static_cast<int>(i));
    angles->InsertNextValue(curves[i].MeanAngle);
    lengths->InsertNextValue(curves[i].Length);
    least->InsertNextValue(curves[i].LeastAngle);
    largest->InsertNextValue(curves[i].LargestAngle);
    kinds->InsertNextValue(static_cast<unsigned char>(curves[i].Kind));
    closed->InsertNextValue(curves[i].Closed ? 1 : 0);
    left->InsertNextValue(curves[i].LeftSurface);
    right->InsertNextValue(curves[i].RightSurface);
  }
}

std::size_t LargestValence(const std::vector<FeatureCorner>& corners)
{
  std::size_t largest = 1;
  for (const FeatureCorner& corner : corners)
  {
    largest = std::max(largest, corner.Curves.size());
  }
  return largest;
}
}

void FillCurves(vtkPolyData* lines, const FeatureSet& features, const std::vector<Vec3>& points,
  double resampleStep, vtkPolyData* mesh)
{
  const std::vector<Curve>& curves = features.Network.Curves;
  std::vector<std::vector<CurvePoint>> samples;
  vtkIdType count = 0;
  for (const Curve& curve : curves)
  {
    samples.push_back(
      resampleStep > 0.0 ? Resampled(curve, points, resampleStep) : VerticesOf(curve));
    count += static_cast<vtkIdType>(samples.back().size());
  }
  CurvePoints writer(lines, count, mesh);
  vtkNew<vtkCellArray> cells;
  std::vector<CurveProperties> properties;
  vtkIdType first = 0;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const Curve& curve = curves[i];
    writer.Add(curve, samples[i], Tangents(curve, points), AnglesAlong(curve, features.Edges));
    properties.push_back(DescribeCurve(curve, features.Edges, features.Faces.Ids, points));
    const auto size = static_cast<vtkIdType>(samples[i].size());
    cells->InsertNextCell(static_cast<int>(size) + (properties.back().Closed ? 1 : 0));
    for (vtkIdType j = 0; j < size; ++j)
    {
      cells->InsertCellPoint(first + j);
    }
    if (properties.back().Closed)
    {
      cells->InsertCellPoint(first);
    }
    first += size;
  }
  writer.Finish();
  lines->SetLines(cells);
  AddCurveProperties(lines, properties);
}

void FillCorners(
  vtkPolyData* vertices, const std::vector<FeatureCorner>& corners, vtkPolyData* mesh)
{
  const auto count = static_cast<vtkIdType>(corners.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  vtkPointData* data = vertices->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(mesh->GetPointData(), count);
  data->SetNumberOfTuples(count);
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, mesh->GetPoint(corners[i].Vertex));
    data->CopyData(mesh->GetPointData(), corners[i].Vertex, i);
    cells->InsertNextCell(1, &i);
  }
  vertices->SetPoints(points);
  vertices->SetVerts(cells);

  const std::size_t width = LargestValence(corners);
  const auto valence = NewArray<vtkIntArray>(array::Valence, data);
  const auto curves = NewArray<vtkIntArray>(array::CurveIds, data, static_cast<int>(width));
  const auto kinds = NewArray<vtkUnsignedCharArray>(array::CornerKind, data);
  const auto tips = NewArray<vtkUnsignedCharArray>(array::Tip, data);
  const auto ids = NewArray<vtkIdTypeArray>(array::MeshPointId, data);
  for (const FeatureCorner& corner : corners)
  {
    valence->InsertNextValue(corner.Valence);
    for (std::size_t i = 0; i < width; ++i)
    {
      curves->InsertNextValue(i < corner.Curves.size() ? corner.Curves[i] : NoIndex);
    }
    kinds->InsertNextValue(static_cast<unsigned char>(corner.Kind));
    tips->InsertNextValue(corner.Tip ? 1 : 0);
    ids->InsertNextValue(corner.Vertex);
  }
}
}
