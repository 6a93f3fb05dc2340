// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PreviewMarks.h"

#include "Core/Curves.h"
#include "Core/Geometry.h"
#include "Support/Arrays.h"

#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

namespace arris
{
namespace
{
/// Sides of a tube, and steps around a ball and from pole to pole: round enough at the size of an
/// edge, and few, as there are thousands.
constexpr int TubeSides = 6;
constexpr int BallSteps = 6;
constexpr int BallRings = 5;

/// Radii of balls, in those of the tubes.
constexpr double BranchSize = 1.5;
constexpr double JointSize = 2.5;

vtkNew<vtkUnsignedCharArray> Roles(vtkIdType count, SkeletonRole role)
{
  vtkNew<vtkUnsignedCharArray> roles;
  roles->SetName(array::SkeletonRole);
  roles->SetNumberOfValues(count);
  roles->FillValue(static_cast<unsigned char>(role));
  return roles;
}

/// In double precision: marks may be farther out than single precision reaches.
vtkSmartPointer<vtkPoints> NewPoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}

vtkNew<vtkPolyData> OutlineLines(const Mesh& mesh, const std::vector<OutlineSegment>& outline)
{
  const auto points = NewPoints();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkFloatArray> normals; // of the surface, so that the lines are lit as it is
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (const OutlineSegment& segment : outline)
  {
    const vtkIdType ids[2] = { points->InsertNextPoint(segment.Begin.data()),
      points->InsertNextPoint(segment.End.data()) };
    lines->InsertNextCell(2, ids);
    const Vec3 normal = Corners(mesh, segment.Triangle).AreaVector().normalized();
    normals->InsertNextTuple(normal.data());
    normals->InsertNextTuple(normal.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->SetNormals(normals);
  data->GetCellData()->AddArray(Roles(lines->GetNumberOfCells(), SkeletonRole::None));
  return data;
}

vtkNew<vtkPolyData> Tubes(const Mesh& mesh, const Skeleton& skeleton, double radius)
{
  vtkNew<vtkPolyData> curves;
  const auto points = NewPoints();
  vtkNew<vtkCellArray> lines;
  for (const Curve& curve : JoinEdges(skeleton.Edges(), mesh.Points).Curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.size()));
    for (const Index v : curve)
    {
      lines->InsertCellPoint(points->InsertNextPoint(mesh.Points[v].data()));
    }
  }
  curves->SetPoints(points);
  curves->SetLines(lines);

  vtkNew<vtkPolyData> data;
  if (lines->GetNumberOfCells() > 0)
  {
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(curves);
    tubes->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    tubes->SetRadius(radius);
    tubes->SetNumberOfSides(TubeSides);
    tubes->Update();
    data->ShallowCopy(tubes->GetOutput());
  }
  data->GetCellData()->AddArray(Roles(data->GetNumberOfCells(), SkeletonRole::Branch));
  return data;
}

vtkNew<vtkPolyData> Balls(const Mesh& mesh, const Skeleton& skeleton, double tubeRadius)
{
  const auto points = NewPoints();
  vtkNew<vtkUnsignedCharArray> roles;
  roles->SetName(array::SkeletonRole);
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("Size");
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    const SkeletonRole role = skeleton.Roles[v];
    if (role != SkeletonRole::None)
    {
      points->InsertNextPoint(mesh.Points[v].data());
      roles->InsertNextValue(static_cast<unsigned char>(role));
      sizes->InsertNextValue(
        static_cast<float>(role == SkeletonRole::Branch ? BranchSize : JointSize));
    }
  }
  vtkNew<vtkPolyData> centers;
  centers->SetPoints(points);
  centers->GetPointData()->AddArray(roles);
  centers->GetPointData()->SetScalars(sizes);

  vtkNew<vtkPolyData> data;
  if (points->GetNumberOfPoints() > 0)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    ball->SetRadius(tubeRadius);
    ball->SetThetaResolution(BallSteps);
    ball->SetPhiResolution(BallRings);
    vtkNew<vtkGlyph3D> glyphs;
    glyphs->SetInputData(centers);
    glyphs->SetSourceConnection(ball->GetOutputPort());
    glyphs->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    glyphs->SetScaleModeToScaleByScalar();
    glyphs->FillCellDataOn();
    glyphs->Update();
    data->ShallowCopy(glyphs->GetOutput());
  }
  return data;
}
}

void FillMarks(vtkPolyData* marks, const Mesh& mesh, const std::vector<OutlineSegment>& outline,
  const Skeleton& skeleton, double tubeRadius)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(OutlineLines(mesh, outline));
  append->AddInputData(Tubes(mesh, skeleton, tubeRadius));
  append->AddInputData(Balls(mesh, skeleton, tubeRadius));
  append->Update();
  marks->ShallowCopy(append->GetOutput());
  marks->GetCellData()->SetActiveScalars(array::SkeletonRole);
}
}
