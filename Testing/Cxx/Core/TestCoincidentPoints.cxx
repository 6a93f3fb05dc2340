// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Assembly/CoincidentPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace arris;

namespace
{
std::vector<Index> UpTo(std::size_t count)
{
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// The same by a look at all pairs.
std::vector<Index> ByAllPairs(
  const std::vector<Vec3>& points, const std::vector<Index>& vertices, double tolerance)
{
  std::vector<Index> lowest(vertices.size(), NoIndex);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    for (std::size_t j = i; lowest[i] == NoIndex && j < vertices.size(); ++j)
    {
      if (lowest[j] == NoIndex && j > i &&
        (points[vertices[i]] - points[vertices[j]]).norm() <= tolerance)
      {
        lowest[j] = vertices[i];
      }
    }
    lowest[i] = lowest[i] == NoIndex ? vertices[i] : lowest[i];
  }
  return lowest;
}
}

TEST(CoincidentPoints, EqualOnesAreTheLowest)
{
  const Vec3 a(0.1, 0.2, 0.3);
  const Vec3 b(-7.0, 0.2, 0.3);
  EXPECT_EQ(
    LowestCoincident({ a, b, a, b, a }, UpTo(5), 0.0), (std::vector<Index>{ 0, 1, 0, 1, 0 }));
  EXPECT_EQ(LowestCoincident({ a, b, a, b, a }, { 1, 2, 4 }, 0.0), (std::vector<Index>{ 1, 2, 2 }));
  EXPECT_EQ(LowestCoincident({ a, a, a }, UpTo(3), 0.0), (std::vector<Index>{ 0, 0, 0 }));
  EXPECT_TRUE(LowestCoincident({}, {}, 1.0).empty());
}

TEST(CoincidentPoints, AreTheSameByAllPairs)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-3.0, 5.0);
  for (const double tolerance : { 0.0, 1e-9, 0.05, 0.4, 20.0 })
  {
    std::vector<Vec3> points;
    for (int i = 0; i < 150; ++i)
    {
      points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
      points.push_back(points[points.size() / 2] + Vec3(0.0, 0.99 * tolerance, 0.0));
      points.push_back(points[points.size() / 3]);
    }
    const std::vector<Index> all = UpTo(points.size());
    EXPECT_EQ(LowestCoincident(points, all, tolerance), ByAllPairs(points, all, tolerance))
      << "tolerance " << tolerance;
  }
}

TEST(CoincidentPoints, FindsAllOfManyThreefoldPoints)
{
  // As many points as several threads would share, each three times.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0.0, 100.0);
  std::vector<Vec3> points;
  constexpr Index Count = 20000;
  for (Index i = 0; i < Count; ++i)
  {
    points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
  }
  for (int copy = 0; copy < 2; ++copy)
  {
    for (Index i = 0; i < Count; ++i)
    {
      points.push_back(points[i]);
    }
  }
  const std::vector<Index> lowest = LowestCoincident(points, UpTo(points.size()), 1e-6);
  for (std::size_t i = 0; i < lowest.size(); ++i)
  {
    ASSERT_EQ(lowest[i], static_cast<Index>(i) % Count);
  }
}

TEST(CoincidentPoints, OfSomeAreToldFromTheirChainsAlone)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  for (const double tolerance : { 0.0, 1e-9, 0.02 })
  {
    // Chains whose links are as long as they may be: many leave the cell that they begin in.
    std::vector<Vec3> points;
    for (int chain = 0; chain < 40; ++chain)
    {
      points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
      for (int link = 0; link < chain; ++link)
      {
        points.push_back(points.back() + Vec3(0.99 * tolerance, 0.0, 0.0));
      }
    }
    std::shuffle(points.begin(), points.end(), random);
    const std::vector<Index> all = UpTo(points.size());
    const std::vector<Index> lowest = LowestCoincident(points, all, tolerance);
    const std::vector<Index> seeds = { 3, 70, 71, 500 };
    const std::vector<Index> near = MayCoincideWith(seeds, points, all, tolerance);
    EXPECT_LT(near.size(), all.size());
    const std::vector<Index> lowestNear = LowestCoincident(points, near, tolerance);
    for (const Index seed : seeds)
    {
      const auto at = std::lower_bound(near.begin(), near.end(), seed) - near.begin();
      ASSERT_LT(static_cast<std::size_t>(at), near.size());
      EXPECT_EQ(lowestNear[at], lowest[seed]) << "tolerance " << tolerance << ", vertex " << seed;
    }
  }
}
