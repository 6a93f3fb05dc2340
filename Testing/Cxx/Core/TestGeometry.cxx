// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Geometry.h"

#include "Meshes.h"

#include <gtest/gtest.h>

#include <random>

using namespace arris;
using namespace arris::testing;

namespace
{
const Corners Unit(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));

double Distance(const Vec3& point, const Corners& triangle)
{
  return std::sqrt(SquaredDistance(point, triangle));
}
}

TEST(Geometry, DistanceInEachRegionOfATriangle)
{
  EXPECT_DOUBLE_EQ(Distance(Vec3(0.25, 0.25, 2.0), Unit), 2.0) << "above the inside";
  EXPECT_DOUBLE_EQ(Distance(Vec3(0.25, 0.25, -2.0), Unit), 2.0) << "below the inside";
  EXPECT_DOUBLE_EQ(Distance(Vec3(0.2, 0.3, 0.0), Unit), 0.0) << "in it";
  EXPECT_DOUBLE_EQ(Distance(Vec3(0.5, -3.0, 4.0), Unit), 5.0) << "edge AB";
  EXPECT_DOUBLE_EQ(Distance(Vec3(-3.0, 0.5, 4.0), Unit), 5.0) << "edge CA";
  EXPECT_DOUBLE_EQ(Distance(Vec3(1.5, 1.5, 0.0), Unit), std::sqrt(2.0)) << "edge BC";
  EXPECT_DOUBLE_EQ(Distance(Vec3(-3.0, -4.0, 0.0), Unit), 5.0) << "corner A";
  EXPECT_DOUBLE_EQ(Distance(Vec3(4.0, -1.0, 0.0), Unit), std::sqrt(10.0)) << "corner B";
  EXPECT_DOUBLE_EQ(Distance(Vec3(-1.0, 3.0, 2.0), Unit), 3.0) << "corner C";
}

TEST(Geometry, DistanceIsToTheTriangleNotToItsPlane)
{
  EXPECT_DOUBLE_EQ(Distance(Vec3(100.0, 0.0, 0.0), Unit), 99.0);
}

TEST(Geometry, DistanceToTrianglesWithoutArea)
{
  const Corners segment(Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(2, 0, 0));
  EXPECT_DOUBLE_EQ(Distance(Vec3(3.0, 2.0, 0.0), segment), 2.0);
  EXPECT_DOUBLE_EQ(Distance(Vec3(7.0, 4.0, 0.0), segment), 5.0);
  const Corners point(Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1));
  EXPECT_DOUBLE_EQ(Distance(Vec3(1.0, 1.0, 3.0), point), 2.0);
}

TEST(Geometry, DistanceAgreesWithTheNearestOfManyPointsOnTheTriangle)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const auto any = [&] { return Vec3(coordinate(random), coordinate(random), coordinate(random)); };
  constexpr int Steps = 60;
  for (int trial = 0; trial < 200; ++trial)
  {
    const Corners t(any(), any(), any());
    const Vec3 p = 2.0 * any();
    double sampled = 1e9;
    for (int i = 0; i <= Steps; ++i)
    {
      for (int j = 0; i + j <= Steps; ++j)
      {
        const double u = static_cast<double>(i) / Steps;
        const double v = static_cast<double>(j) / Steps;
        sampled = std::min(sampled, (p - (t.A + u * (t.B - t.A) + v * (t.C - t.A))).norm());
      }
    }
    // No sample can be nearer, and one lies within a step of the nearest point.
    const double step = ((t.B - t.A).norm() + (t.C - t.A).norm()) / Steps;
    EXPECT_LE(Distance(p, t), sampled + 1e-12);
    EXPECT_GE(Distance(p, t), sampled - step);
  }
}

TEST(Geometry, DifferenceOfAngleIsThePapersThreshold)
{
  EXPECT_NEAR(DifferenceOfAngle(std::acos(0.75) * 180.0 / Pi), 0.25, 1e-15);
  EXPECT_DOUBLE_EQ(DifferenceOfAngle(180.0), 2.0);
  EXPECT_DOUBLE_EQ(DifferenceOfAngle(90.0), 1.0);
  EXPECT_EQ(DifferenceOfAngle(0.0), 0.0);
}

TEST(Geometry, AngleOfDifferenceIsItsInverseDownToTinyAngles)
{
  // 1 - cos would keep no digit of an angle of a ten-millionth of a degree.
  for (const double degrees : { 1e-7, 1e-3, 1.0, 41.4, 90.0, 135.0, 179.0 })
  {
    EXPECT_NEAR(AngleOfDifference(DifferenceOfAngle(degrees)), degrees, 1e-12 * degrees);
  }
  EXPECT_DOUBLE_EQ(AngleOfDifference(2.0 + 1e-15), 180.0) << "rounding must not leave acos's range";
}

TEST(Geometry, NormalsAreUnitVectorsByTheRightHandRule)
{
  const Mesh mesh = Sphere(3.0, 6);
  const std::vector<Vec3> normals = UnitNormals(mesh, 1.0);
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    EXPECT_NEAR(normals[t].norm(), 1.0, 1e-14);
    EXPECT_GT(normals[t].dot(Corners(mesh, t).Centroid()), 0.0) << "outwards";
  }
}

TEST(Geometry, SliversHaveNoNormal)
{
  Mesh mesh;
  for (const double height : { 0.0, 0.9 * SliverHeight, 1.1 * SliverHeight })
  {
    Append(mesh, { { Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(1, height, 0) }, { { 0, 1, 2 } } });
  }
  const std::vector<Vec3> normals = UnitNormals(mesh, 1.0);
  EXPECT_TRUE(normals[0].isZero(0.0));
  EXPECT_TRUE(normals[1].isZero(0.0)) << "the least height is relative to the average edge";
  EXPECT_NEAR(normals[2].z(), 1.0, 1e-15);
  const std::vector<Vec3> trusting = UnitNormals(mesh, 0.0);
  EXPECT_TRUE(trusting[0].isZero(0.0)) << "without area there never is a normal";
  EXPECT_NEAR(trusting[1].z(), 1.0, 1e-15);
}

TEST(Geometry, NormalsDoNotDependOnTheUnitOfLength)
{
  for (const double scale : { 1e-30, 1e-6, 1e6, 1e30 })
  {
    Mesh mesh = FlatGrid(1, 1);
    for (Vec3& point : mesh.Points)
    {
      point *= scale;
    }
    EXPECT_NEAR(UnitNormals(mesh, scale)[0].z(), 1.0, 1e-15) << "scale " << scale;
  }
}
