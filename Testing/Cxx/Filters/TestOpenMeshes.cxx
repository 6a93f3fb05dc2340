// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkClipPolyData.h>
#include <vtkPlane.h>

using namespace arris::testing;

// A contour cut open by a plane: its free boundary stays in that plane, and edges that run into it
// get their corners there.

namespace
{
constexpr int Samples = 48;

/// The cut, across the box' edges along z at an angle.
Point3 CutNormal()
{
  return Solid::Rotation() * Point3(0.2, 0.3, 1.0).normalized();
}

double Height(const Point3& p)
{
  return CutNormal().dot(p - Solid::Offset());
}

/// vtkClipPolyData keeps heights in single precision: so near to the plane are the points it makes.
constexpr double InPlane = 1e-6;

/// What is below the plane.
vtkSmartPointer<vtkPolyData> CutContour(const Solid& solid)
{
  const auto whole = Contour(solid, Samples);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(whole->GetPoints());
  whole->SetPoints(points);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(Solid::Offset().data());
  plane->SetNormal(CutNormal().data());
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(whole);
  clip->SetClipFunction(plane);
  clip->InsideOutOn();
  clip->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  clip->Update();
  return clip->GetOutput();
}

vtkSmartPointer<vtkPolyData> Recover(vtkPolyData* mesh, int method)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetMethod(method);
  const auto after = Execute(filter, mesh);
  EXPECT_GT(filter->GetNumberOfOpenEdges(), 0);
  return after;
}

/// The numbers of the points that the cut has made.
std::vector<vtkIdType> Rim(vtkPolyData* mesh)
{
  std::vector<vtkIdType> rim;
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    if (std::abs(Height(Point3(mesh->GetPoint(v)))) < InPlane)
    {
      rim.push_back(v);
    }
  }
  return rim;
}

class OpenMeshes : public ::testing::TestWithParam<int>
{
};
}

TEST_P(OpenMeshes, KeepTheirBoundaryInThePlaneThatCutThem)
{
  for (const Solid& solid : { BoxSolid(), BracketSolid() })
  {
    const auto before = CutContour(solid);
    const auto after = Recover(before, GetParam());
    const std::vector<vtkIdType> rim = Rim(before);
    ASSERT_GT(rim.size(), 100u);
    int moved = 0;
    for (const vtkIdType v : rim)
    {
      const Point3 p(after->GetPoint(v));
      EXPECT_LT(std::abs(Height(p)), 2.0 * InPlane) << "point " << v;
      moved += (p - Point3(before->GetPoint(v))).norm() > InPlane ? 1 : 0;
    }
    EXPECT_GT(moved, 3) << "or no edge ran into the boundary";
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, OpenMeshes,
  ::testing::Values(vtkSharpEdgeReconstruction::PAPER, vtkSharpEdgeReconstruction::ROBUST),
  [](const auto& test)
  { return std::string(test.param == vtkSharpEdgeReconstruction::PAPER ? "Paper" : "Robust"); });

TEST(OpenBox, HasItsEdgesUpToTheBoundary)
{
  const auto before = CutContour(BoxSolid());
  const auto after = Recover(before, vtkSharpEdgeReconstruction::ROBUST);
  const double cell = CellWidth(Samples);
  const auto nearest = [&](vtkPolyData* mesh, const Point3& corner)
  {
    double least = 1e30;
    for (const vtkIdType v : Rim(before))
    {
      least = std::min(least, (Point3(mesh->GetPoint(v)) - corner).norm());
    }
    return least / cell;
  };
  for (const double x : { -0.6, 0.6 })
  {
    for (const double y : { -0.5, 0.5 })
    {
      const Point3 corner =
        Solid::Rotation() * Point3(x, y, -0.2 * x - 0.3 * y) + Solid::Offset(); // in the plane
      EXPECT_GT(nearest(before, corner), 0.2) << "or the contour did not lose it";
      EXPECT_LT(nearest(after, corner), 0.05);
    }
  }
}

TEST(OpenTube, StaysAsItIs)
{
  // Its free end is no sharp edge.
  const auto before = CutContour(CylinderSolid());
  const auto after = Recover(before, vtkSharpEdgeReconstruction::ROBUST);
  for (const vtkIdType v : Rim(before))
  {
    EXPECT_EQ(Point3(after->GetPoint(v)), Point3(before->GetPoint(v)));
  }
}
