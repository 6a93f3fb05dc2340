// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/NormalSpread.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace arris;

namespace
{
std::vector<Index> All(const std::vector<Vec3>& normals)
{
  std::vector<Index> indices(normals.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

double Largest(const std::vector<Vec3>& normals)
{
  return NormalSpread().Largest(All(normals), normals);
}

/// By looking at every pair.
double LargestOfAllPairs(const std::vector<Index>& triangles, const std::vector<Vec3>& normals)
{
  double largest = 0.0;
  for (const Index a : triangles)
  {
    for (const Index b : triangles)
    {
      largest = std::max(largest, 0.5 * (normals[a] - normals[b]).squaredNorm());
    }
  }
  return largest;
}

/// Normals within `spread` of one direction: from a narrow cone to all directions.
std::vector<Vec3> RandomNormals(std::mt19937& random, int count, double spread)
{
  std::normal_distribution<double> coordinate;
  const auto any = [&] { return Vec3(coordinate(random), coordinate(random), coordinate(random)); };
  const Vec3 axis = any().normalized();
  std::vector<Vec3> normals;
  normals.reserve(count);
  for (int i = 0; i < count; ++i)
  {
    normals.push_back((axis + spread * any()).normalized());
  }
  return normals;
}
}

TEST(NormalSpread, OfFewerThanTwoNormalsIsNothing)
{
  EXPECT_EQ(Largest({}), 0.0);
  EXPECT_EQ(Largest({ Vec3::UnitX() }), 0.0);
}

TEST(NormalSpread, OfEqualNormalsIsNothing)
{
  const Vec3 normal = Vec3(1, 2, 3).normalized();
  EXPECT_EQ(Largest({ normal, normal, normal }), 0.0);
}

TEST(NormalSpread, OfKnownAngles)
{
  EXPECT_DOUBLE_EQ(Largest({ Vec3::UnitX(), Vec3::UnitY() }), 1.0);
  EXPECT_DOUBLE_EQ(Largest({ Vec3::UnitX(), Vec3(0.6, 0.8, 0.0) }), 0.4);
  EXPECT_DOUBLE_EQ(Largest({ Vec3::UnitX(), Vec3(-Vec3::UnitX()) }), 2.0) << "the axis vanishes";
}

TEST(NormalSpread, KeepsItsDigitsForNearlyEqualNormals)
{
  // 1 - cos of a millionth of a radian is 5e-13: a cosine knows three digits of it.
  const double angle = 1e-6;
  const double spread = Largest({ Vec3::UnitX(), Vec3(std::cos(angle), std::sin(angle), 0.0) });
  EXPECT_NEAR(spread / (0.5 * angle * angle), 1.0, 1e-9);
}

TEST(NormalSpread, TrianglesWithoutNormalDoNotCount)
{
  EXPECT_DOUBLE_EQ(
    Largest({ Vec3::Zero(), Vec3::UnitX(), Vec3::Zero(), Vec3(0.6, 0.8, 0.0) }), 0.4);
  EXPECT_EQ(Largest({ Vec3::Zero(), Vec3::UnitX() }), 0.0);
}

TEST(NormalSpread, LooksOnlyAtTheTrianglesNamed)
{
  const std::vector<Vec3> normals = { Vec3::UnitX(), Vec3(-Vec3::UnitX()), Vec3::UnitY() };
  EXPECT_DOUBLE_EQ(NormalSpread().Largest({ 0, 2 }, normals), 1.0);
}

TEST(NormalSpread, AgreesWithAllPairs)
{
  std::mt19937 random(3);
  NormalSpread spread; // reused from set to set, as it is from vertex to vertex
  for (const double width : { 1e-6, 0.01, 0.3, 1.0, 100.0 })
  {
    for (int trial = 0; trial < 200; ++trial)
    {
      const std::vector<Vec3> normals = RandomNormals(random, 2 + trial % 40, width);
      const std::vector<Index> triangles = All(normals);
      ASSERT_EQ(spread.Largest(triangles, normals), LargestOfAllPairs(triangles, normals));
    }
  }
}
