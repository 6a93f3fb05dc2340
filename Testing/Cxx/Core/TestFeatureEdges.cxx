// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/FeatureEdges.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
/// Angles are kept in single precision: 180 degrees to within 1e-5.
constexpr double AngleRounding = 2e-5;

std::vector<FeatureEdge> Find(const Mesh& mesh, double angle)
{
  return FindFeatureEdges(mesh, Connectivity(mesh), angle, Monitor());
}
}

TEST(FeatureEdges, OfAFoldAreItsEdgesWithItsAngle)
{
  for (const double angle : { 1.0, 35.0, 90.0, 150.0, 179.0, -60.0 })
  {
    const std::vector<FeatureEdge> features = Find(Fold(3, 8, angle), 0.5);
    ASSERT_EQ(features.size(), 8u);
    for (std::size_t i = 0; i < features.size(); ++i)
    {
      EXPECT_EQ(features[i].A, static_cast<Index>(7 * i + 3));
      EXPECT_EQ(features[i].B, static_cast<Index>(7 * i + 10));
      EXPECT_NEAR(features[i].DihedralAngle, std::abs(angle), AngleRounding);
    }
  }
}

TEST(FeatureEdges, AreThoseAboveTheAngle)
{
  const Mesh mesh = Fold(3, 8, 35.0);
  EXPECT_TRUE(Find(mesh, 35.001).empty());
  EXPECT_EQ(Find(mesh, 34.999).size(), 8u);
}

TEST(FeatureEdges, OfABox)
{
  const std::vector<FeatureEdge> features = Find(Box(3, 4, 5), 30.0);
  EXPECT_EQ(features.size(), 4u * (3 + 4 + 5));
  EXPECT_TRUE(std::is_sorted(features.begin(), features.end(),
    [](const FeatureEdge& a, const FeatureEdge& b) { return a.A != b.A ? a.A < b.A : a.B < b.B; }));
  for (const FeatureEdge& feature : features)
  {
    EXPECT_LT(feature.A, feature.B);
    EXPECT_NEAR(feature.DihedralAngle, 90.0, AngleRounding);
  }
}

TEST(FeatureEdges, TheBoundaryIsNone)
{
  EXPECT_TRUE(Find(FlatGrid(4, 4), 1.0).empty());
}

TEST(FeatureEdges, AWronglyWoundTriangleIsReadTheOtherWayRound)
{
  Mesh plane = FlatGrid(4, 4);
  std::swap(plane.Triangles[13][1], plane.Triangles[13][2]);
  EXPECT_TRUE(Find(plane, 5.0).empty());

  Mesh fold = Fold(3, 8, 60.0);
  for (std::size_t t = 0; t < fold.Triangles.size(); t += 3)
  {
    std::swap(fold.Triangles[t][0], fold.Triangles[t][2]);
  }
  const std::vector<FeatureEdge> features = Find(fold, 5.0);
  EXPECT_EQ(features.size(), 8u);
  for (const FeatureEdge& feature : features)
  {
    EXPECT_NEAR(feature.DihedralAngle, 60.0, AngleRounding);
  }
}

TEST(FeatureEdges, NonManifoldEdgesAlwaysAreWithTheirLargestAngle)
{
  // Three wings at 120 degrees: any two are folded by 60 against going straight on.
  const std::vector<FeatureEdge> three = Find(Wings(3), 179.0);
  ASSERT_EQ(three.size(), 1u);
  EXPECT_EQ(three[0].A, 0);
  EXPECT_EQ(three[0].B, 1);
  EXPECT_NEAR(three[0].DihedralAngle, 60.0, AngleRounding);
  // Four at right angles: two go straight on, neighbours make 90.
  const std::vector<FeatureEdge> four = Find(Wings(4), 179.0);
  ASSERT_EQ(four.size(), 1u);
  EXPECT_NEAR(four[0].DihedralAngle, 90.0, AngleRounding);
}

TEST(FeatureEdges, TrianglesWithoutAreaMakeNone)
{
  Mesh mesh = FlatGrid(2, 2);
  mesh.Points.emplace_back(0.5, 0.0, 0.0); // on the edge from 0 to 1
  mesh.Triangles.push_back({ 0, 1, 9 });
  EXPECT_TRUE(Find(mesh, 1.0).empty());
}

TEST(FeatureEdges, AreFoundByEitherOrderOfTheirEnds)
{
  const std::vector<FeatureEdge> features = Find(Fold(3, 8, 90.0), 30.0);
  ASSERT_NE(FindFeature(features, 10, 17), nullptr);
  EXPECT_EQ(FindFeature(features, 10, 17), FindFeature(features, 17, 10));
  EXPECT_EQ(FindFeature(features, 10, 17)->A, 10);
  EXPECT_EQ(FindFeature(features, 10, 11), nullptr) << "an edge, but flat";
  EXPECT_EQ(FindFeature(features, 58, 59), nullptr) << "after the last";
  EXPECT_EQ(FindFeature({}, 0, 1), nullptr);
}

TEST(FeatureEdges, GiveNothingWhenStopped)
{
  const Mesh mesh = Box(2, 2, 2);
  EXPECT_TRUE(
    FindFeatureEdges(mesh, Connectivity(mesh), 30.0, Monitor([](double) { return false; }))
      .empty());
}
