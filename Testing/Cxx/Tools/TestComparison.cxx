// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Comparison.h"
#include "Failure.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using arris::Compare;
using arris::Comparison;
using arris::SurfaceDistance;

namespace
{
constexpr double Rounding = 1e-12;

/// One quad from (0, 0) to (width, 1) at a height.
vtkSmartPointer<vtkPolyData> Rectangle(double width, double height = 0.0)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, height);
  points->InsertNextPoint(width, 0.0, height);
  points->InsertNextPoint(width, 1.0, height);
  points->InsertNextPoint(0.0, 1.0, height);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2, 3 });
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> Cube(double half)
{
  vtkNew<vtkCubeSource> source;
  source->SetBounds(-half, half, -half, half, -half, half);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> Sphere(double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(100);
  source->SetPhiResolution(100);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

void ExpectEverywhere(const SurfaceDistance& distance, double expected, double tolerance)
{
  EXPECT_NEAR(distance.Max, expected, tolerance);
  EXPECT_NEAR(distance.Mean, expected, tolerance);
  EXPECT_NEAR(distance.Rms, expected, tolerance);
  EXPECT_GT(distance.Samples, 0);
}
}

TEST(Comparison, AMeshWithItself)
{
  const auto sphere = Sphere(1.0);
  const Comparison result = Compare(sphere, sphere, 20000);
  ExpectEverywhere(result.ReferenceToMesh, 0.0, Rounding);
  ExpectEverywhere(result.MeshToReference, 0.0, Rounding);
}

TEST(Comparison, SquaresAQuarterApart)
{
  const Comparison result = Compare(Rectangle(1.0), Rectangle(1.0, 0.25));
  ExpectEverywhere(result.ReferenceToMesh, 0.25, Rounding);
  ExpectEverywhere(result.MeshToReference, 0.25, Rounding);
  EXPECT_NEAR(result.Diagonal, std::sqrt(2.0), Rounding);
}

TEST(Comparison, DirectionsDiffer)
{
  // The distance from the missing half grows from 0 to a half with x.
  const Comparison result = Compare(Rectangle(1.0), Rectangle(0.5));
  EXPECT_NEAR(result.ReferenceToMesh.Max, 0.5, Rounding);
  EXPECT_NEAR(result.ReferenceToMesh.Mean, 0.125, 1e-4);
  EXPECT_NEAR(result.ReferenceToMesh.Rms, std::sqrt(1.0 / 24.0), 1e-4);
  ExpectEverywhere(result.MeshToReference, 0.0, Rounding);
}

TEST(Comparison, ConcentricSpheres)
{
  const Comparison result = Compare(Sphere(1.0), Sphere(1.1), 20000);
  const double flat = 1.5e-3; // how far the facets are from the spheres, and some
  ExpectEverywhere(result.ReferenceToMesh, 0.1, flat);
  ExpectEverywhere(result.MeshToReference, 0.1, flat);
}

TEST(Comparison, CubeInCube)
{
  const double d = 0.2;
  const Comparison result = Compare(Cube(1.0), Cube(1.0 + d));
  ExpectEverywhere(result.ReferenceToMesh, d, Rounding);
  EXPECT_NEAR(result.MeshToReference.Max, std::sqrt(3.0) * d, Rounding); // at the corners
  EXPECT_NEAR(result.MeshToReference.Rms, std::sqrt(d * d + 2.0 * d * d * d / (3.0 * (1.0 + d))),
    1e-4); // integrated over a face
  EXPECT_NEAR(result.Diagonal, 2.0 * std::sqrt(3.0), Rounding);
}

TEST(Comparison, IsToTriangles)
{
  // A small square above the middle of a large one, all of whose vertices are far away.
  const auto small = Rectangle(1.0, 0.25);
  EXPECT_NEAR(Compare(small, Cube(100.0)).ReferenceToMesh.Max, 99.75, 1e-9);
}

TEST(Comparison, MoreSamplesWhenAskedFor)
{
  const auto square = Rectangle(1.0);
  const vtkIdType few = Compare(square, square, 100).ReferenceToMesh.Samples;
  const vtkIdType many = Compare(square, square, 10000).ReferenceToMesh.Samples;
  EXPECT_GE(few, 100);
  EXPECT_LT(few, 200);
  EXPECT_GE(many, 10000);
}

TEST(Comparison, PointsInNoCellDoNotCount)
{
  const auto reference = Rectangle(1.0);
  reference->GetPoints()->InsertNextPoint(50.0, 0.0, 0.0);
  const Comparison result = Compare(reference, Rectangle(1.0));
  ExpectEverywhere(result.ReferenceToMesh, 0.0, Rounding);
  EXPECT_NEAR(result.Diagonal, std::sqrt(2.0), Rounding);
}

TEST(Comparison, SameForAnyNumberOfThreads)
{
  const auto reference = Sphere(1.0);
  const auto mesh = Cube(0.7);
  const auto measure = [&](int threads)
  {
    Comparison result;
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
      [&] { result = Compare(reference, mesh, 5000); });
    return result;
  };
  const Comparison one = measure(1);
  const Comparison two = measure(2);
  EXPECT_EQ(one.ReferenceToMesh.Mean, two.ReferenceToMesh.Mean);
  EXPECT_EQ(one.ReferenceToMesh.Rms, two.ReferenceToMesh.Rms);
  EXPECT_EQ(one.MeshToReference.Mean, two.MeshToReference.Mean);
  EXPECT_EQ(one.MeshToReference.Max, two.MeshToReference.Max);
}

TEST(Comparison, ProgressRisesFromZeroToOne)
{
  std::vector<double> heard;
  const auto square = Rectangle(1.0);
  Compare(square, square, 100, [&](double fraction) { heard.push_back(fraction); });
  ASSERT_FALSE(heard.empty());
  EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
  EXPECT_GE(heard.front(), 0.0);
  EXPECT_LE(heard.back(), 1.0);
}

TEST(Comparison, RefusesWhatHasNoArea)
{
  const auto square = Rectangle(1.0);
  EXPECT_THROW(Compare(square, Rectangle(0.0)), arris::Failure);
  EXPECT_THROW(Compare(vtkNew<vtkPolyData>(), square), arris::Failure);
}

TEST(Comparison, RefusesPointsThatAreNotFinite)
{
  const double bad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Compare(Rectangle(1.0), Rectangle(1.0, bad)), arris::Failure);
}
