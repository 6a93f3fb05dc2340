// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Features/Noise.h"

#include "Features.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr double NoiseFactor = 30.0; // the filter's default

/// Criteria as the filter has them by default, without the boundary.
FeatureCriteria UsualCriteria()
{
  FeatureCriteria criteria = PlainCriteria(30.0);
  criteria.Band.Continuation = 15.0;
  criteria.NoiseFactor = NoiseFactor;
  criteria.TailLength = 2.0 * 1.14; // mean edge of a grid of unit squares: (1 + 1 + 1.41) / 3
  return criteria;
}
}

TEST(Noise, OfAPlateIsNoFeature)
{
  for (const double size : { 0.05, 0.1, 0.15 }) // 0.17: as much as normal noise of a tenth an edge
  {
    const Mesh plate = Noisy(FlatGrid(150, 150), size * 1.14);
    EXPECT_TRUE(Select(plate, UsualCriteria()).empty()) << size;
  }
  // Not because there is nothing to see there:
  EXPECT_GT(FeaturesAbove(Noisy(FlatGrid(150, 150), 0.15 * 1.14), 30.0).size(), 1000u);
}

TEST(Noise, OfASphereIsNoFeatureEither)
{
  EXPECT_TRUE(Select(Noisy(Sphere(20.0, 30), 0.1), UsualCriteria()).empty());
}

TEST(Noise, LeavesAnEdgeThatStandsOut)
{
  const Mesh mesh = Noisy(Fold(20, 60, 90.0), 0.1);
  double length = 0.0;
  for (const FeatureEdge& edge : Select(mesh, UsualCriteria()))
  {
    const Vec3 middle = 0.5 * (mesh.Points[edge.A] + mesh.Points[edge.B]);
    EXPECT_LT(std::abs(middle.x()), 1.0) << "off the edge";
    length += std::abs(mesh.Points[edge.B].y() - mesh.Points[edge.A].y());
  }
  EXPECT_GT(length, 55.0);
}

TEST(Noise, IsTheSameWhetherAllFoldsAreKeptOrNot)
{
  const Mesh mesh = Noisy(Fold(20, 60, 90.0), 0.1);
  const Connectivity connectivity(mesh);
  const Folds kept = FindFolds(mesh, connectivity, Monitor());
  ASSERT_FALSE(kept.Differences.empty());
  Folds asked = kept;
  asked.Differences.clear();
  const std::vector<FeatureEdge> edges = CandidateEdges(mesh, connectivity, kept, 10.0);
  EXPECT_EQ(QuietAngles(mesh, connectivity, kept, edges, NoiseFactor, Monitor()),
    QuietAngles(mesh, connectivity, asked, edges, NoiseFactor, Monitor()));
}

TEST(Noise, IsNotSeenInPartsOfFewTriangles)
{
  EXPECT_EQ(Select(Box(1, 1, 1), UsualCriteria()).size(), 12u);
  EXPECT_EQ(Select(Box(3, 4, 5), UsualCriteria()).size(), 48u);
}

TEST(Noise, IsNotSeenInFlutes)
{
  // Flanks one triangle wide, folded up and down by 90 degrees in turn.
  std::vector<Vec3> profile;
  for (Index i = 0; i <= 40; ++i)
  {
    profile.emplace_back(i, 0.0, i % 2 == 0 ? 0.0 : 1.0);
  }
  const Mesh flutes = Extrude(profile, 20, Vec3(0.0, 1.0, 0.0));
  EXPECT_EQ(Select(flutes, UsualCriteria()).size(), 39u * 20u);
}

TEST(Noise, IsShapeIfToldSo)
{
  FeatureCriteria criteria = UsualCriteria();
  criteria.NoiseFactor = 0.0;
  EXPECT_FALSE(Select(Noisy(FlatGrid(150, 150), 0.15 * 1.14), criteria).empty());
}
