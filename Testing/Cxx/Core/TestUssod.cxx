// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/EdgeLengths.h"
#include "Core/Ussod.h"

#include "Core/Geometry.h"
#include "Meshes.h"
#include "PlainUssod.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace arris;
using namespace arris::testing;

namespace
{
std::vector<double> Differences(const Mesh& mesh, double radius, WindowSearch search)
{
  const Connectivity connectivity(mesh);
  const std::vector<Vec3> normals = UnitNormals(mesh, AverageEdgeLength(mesh, connectivity));
  return NormalDifferences(mesh, connectivity, normals, radius, search, Monitor());
}

/// Each closed form holds for both ways to search.
class Ussod : public ::testing::TestWithParam<WindowSearch>
{
protected:
  static std::vector<double> Differences(const Mesh& mesh, double radius)
  {
    return ::Differences(mesh, radius, GetParam());
  }
};

/// How far the normal of a triangle near a vertex may be turned on a surface of least radius of
/// curvature `radius`: by its window, and by the triangle itself, whose normal belongs to some
/// point of the surface within an edge length.
double LargestTurn(double window, double edge, double radius)
{
  return 2.0 * (window + edge) / radius * 180.0 / Pi;
}
double SmallestTurn(double window, double edge, double radius)
{
  return 2.0 * (window - edge) / radius * 180.0 / Pi;
}
}

TEST_P(Ussod, OfAPlaneIsExactlyNothing)
{
  for (const double difference : Differences(FlatGrid(6, 6), 2.0))
  {
    EXPECT_EQ(difference, 0.0);
  }
}

TEST_P(Ussod, OfAFoldIsTheAngleInReachAndNothingBeyond)
{
  constexpr Index Width = 5;
  for (const double angle : { 10.0, 45.0, 90.0, -60.0 })
  {
    const Mesh mesh = Fold(Width, 6, angle);
    const std::vector<double> differences = Differences(mesh, 1.5);
    for (Index v = 0; v < mesh.VertexCount(); ++v)
    {
      const Index column = std::abs(v % (2 * Width + 1) - Width); // units from the fold
      const double expected = column <= 1 ? DifferenceOfAngle(angle) : 0.0;
      EXPECT_NEAR(differences[v], expected, 1e-14) << "angle " << angle << ", column " << column;
    }
  }
}

TEST_P(Ussod, TheWindowIsClosed)
{
  // The paper's window takes d <= λ. In these coordinates the distance 1 is exact.
  const Mesh mesh = Extrude(
    { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(2, 0, -1) }, 4, Vec3(0.0, 1.0, 0.0));
  EXPECT_DOUBLE_EQ(Differences(mesh, 1.0)[2 * 4 + 1], 1.0);
  EXPECT_EQ(Differences(mesh, std::nextafter(1.0, 0.0))[2 * 4 + 1], 0.0);
}

TEST_P(Ussod, OfACylinderIsTheTurnOfItsFacetsInReach)
{
  // Facet j away from a vertex begins at the chord 2 R sin(π j / n): those up to the last j with
  // chord <= λ are in the window, on both sides, and the outermost two differ by 2 j + 1 facets.
  constexpr double Radius = 10.0;
  constexpr Index Segments = 60;
  const Mesh mesh = Tube(Radius, Segments, 6, 1.0);
  for (const double window : { 0.5, 1.5, 2.5, 6.0 })
  {
    int last = 0;
    while (2.0 * Radius * std::sin(Pi * (last + 1) / Segments) <= window)
    {
      ++last;
    }
    const double turn = (2 * last + 1) * 360.0 / Segments;
    for (const double difference : Differences(mesh, window))
    {
      EXPECT_NEAR(AngleOfDifference(difference), turn, 1e-9) << "window " << window;
    }
  }
}

TEST_P(Ussod, OfASphereIsTheTurnOfItsWindow)
{
  constexpr double Radius = 10.0;
  constexpr double Window = 3.0;
  const Mesh mesh = Sphere(Radius, 30);
  const double edge = LongestEdge(mesh);
  for (const double difference : Differences(mesh, Window))
  {
    EXPECT_LE(AngleOfDifference(difference), LargestTurn(Window, edge, Radius));
    EXPECT_GE(AngleOfDifference(difference), SmallestTurn(Window, edge, Radius));
  }
}

TEST_P(Ussod, OfATorusIsTheTurnAboutItsTube)
{
  constexpr double Tube = 5.0;
  constexpr double Window = 1.5;
  const Mesh mesh = Torus(20.0, Tube, 200, 50);
  const double edge = LongestEdge(mesh);
  for (const double difference : Differences(mesh, Window))
  {
    EXPECT_LE(AngleOfDifference(difference), LargestTurn(Window, edge, Tube));
    EXPECT_GE(AngleOfDifference(difference), SmallestTurn(Window, edge, Tube));
  }
}

TEST_P(Ussod, OfABoxIsSharpNearItsEdgesAlone)
{
  constexpr Index Size = 8;
  const Mesh mesh = Box(Size, Size, Size);
  const std::vector<double> differences = Differences(mesh, 1.5);
  const Flags sharp = SharpRegion(differences, 41.4);
  std::size_t expected = 0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    // Off its own face a vertex sees another where it is within 1.5 of that face's plane.
    int near = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double c = mesh.Points[v][axis];
      near += std::min(c, Size - c) <= 1.5 ? 1 : 0;
    }
    EXPECT_DOUBLE_EQ(differences[v], near > 1 ? 1.0 : 0.0) << mesh.Points[v].transpose();
    expected += near > 1 ? 1 : 0;
  }
  EXPECT_EQ(std::accumulate(sharp.begin(), sharp.end(), std::size_t(0)), expected);
}

TEST_P(Ussod, ScalesWithTheMesh)
{
  Mesh mesh = Torus(3.0, 1.0, 24, 12);
  const std::vector<double> before = Differences(mesh, 0.7);
  for (Vec3& point : mesh.Points)
  {
    point *= 1024.0; // a power of two changes no digit
  }
  EXPECT_EQ(Differences(mesh, 0.7 * 1024.0), before);
}

TEST_P(Ussod, AVertexWithoutTrianglesHasNone)
{
  Mesh mesh = Fold(2, 2, 90.0);
  mesh.Points.emplace_back(50.0, 0.0, 0.0);
  EXPECT_EQ(Differences(mesh, 1.0).back(), 0.0);
}

TEST_P(Ussod, SliversDoNotMakeAPlaneSharp)
{
  // A triangle lower than its rounding looks anywhere: here straight to the side.
  Mesh mesh = FlatGrid(4, 4);
  mesh.Points.emplace_back(1.5, 1.0, 1e-6);
  mesh.Triangles.push_back({ 6, 7, mesh.VertexCount() - 1 });
  for (const double difference : Differences(mesh, 1.0))
  {
    EXPECT_EQ(difference, 0.0);
  }
}

TEST_P(Ussod, GivesNothingWhenStopped)
{
  const Mesh mesh = FlatGrid(3, 3);
  const Connectivity connectivity(mesh);
  EXPECT_TRUE(NormalDifferences(mesh, connectivity, UnitNormals(mesh, 1.0), 1.0, GetParam(),
    Monitor([](double) { return false; }))
                .empty());
}

INSTANTIATE_TEST_SUITE_P(Searches, Ussod,
  ::testing::Values(WindowSearch::Connected, WindowSearch::Spatial),
  [](const auto& test) { return test.param == WindowSearch::Connected ? "Connected" : "Spatial"; });

TEST(Ussod, IsThatOfThePlainFormulaOnRaggedMeshes)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  // Closed, with a boundary, and with edges of three triangles.
  for (Mesh mesh : { Sphere(4.0, 5), ChamferedFold(5, 6, 70.0, 0.4), Wings(3), Box(4, 3, 2) })
  {
    for (Vec3& point : mesh.Points)
    {
      point += Vec3(shift(random), shift(random), shift(random));
    }
    const double edge = AverageEdgeLength(mesh, Connectivity(mesh));
    const std::vector<Vec3> normals = UnitNormals(mesh, edge);
    for (const double ratio : { 0.3, 0.75, 1.0, 1.5, 3.0 })
    {
      const std::vector<double> fast = Differences(mesh, ratio * edge, WindowSearch::Connected);
      for (Index v = 0; v < mesh.VertexCount(); ++v)
      {
        EXPECT_NEAR(fast[v], PlainDifference(mesh, normals, v, ratio * edge), 1e-12)
          << "vertex " << v << ", window " << ratio;
      }
    }
  }
}

TEST(Ussod, OnlyTheSpatialSearchSeesTheOtherSideOfAThinPlate)
{
  const Mesh plate = Box(9, 9, 1);
  const Index centre = [&]
  {
    Index v = 0;
    while (plate.Points[v] != Vec3(4, 4, 0))
    {
      ++v;
    }
    return v;
  }();
  EXPECT_EQ(Differences(plate, 1.2, WindowSearch::Connected)[centre], 0.0);
  EXPECT_DOUBLE_EQ(Differences(plate, 1.2, WindowSearch::Spatial)[centre], 2.0);
}

TEST(SharpRegion, BeginsAtTheSharpAngleItself)
{
  const double threshold = DifferenceOfAngle(41.4);
  EXPECT_EQ(SharpRegion({ threshold, std::nextafter(threshold, 0.0), 0.0, 2.0 }, 41.4),
    (Flags{ 1, 0, 0, 1 }));
}
