// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Features.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
/// 1 - cos of an angle is kept in single precision: an angle of 179 degrees to within 4e-4.
constexpr double AngleRounding = 4e-4;

std::vector<FeatureEdge> Find(const Mesh& mesh, double angle)
{
  return FeaturesAbove(mesh, angle);
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

TEST(FeatureEdges, OfTheBoundaryIfWanted)
{
  EXPECT_TRUE(Find(FlatGrid(4, 3), 1.0).empty());
  FeatureCriteria criteria = PlainCriteria(1.0);
  criteria.Boundary = true;
  const std::vector<FeatureEdge> edges = Select(FlatGrid(4, 3), criteria);
  EXPECT_EQ(edges.size(), 14u);
  for (const FeatureEdge& edge : edges)
  {
    EXPECT_EQ(edge.Kind, EdgeKind::Boundary);
    EXPECT_EQ(edge.DihedralAngle, 0.0);
    EXPECT_NE(edge.Left == NoIndex, edge.Right == NoIndex);
  }
}

TEST(FeatureEdges, AreConvexOrConcave)
{
  for (const double angle : { 60.0, -60.0 })
  {
    for (const FeatureEdge& edge : Find(Fold(3, 8, angle), 30.0))
    {
      EXPECT_EQ(edge.Kind, angle > 0.0 ? EdgeKind::Convex : EdgeKind::Concave);
    }
  }
}

TEST(FeatureEdges, KnowTheTrianglesToTheirLeftAndRight)
{
  const Mesh mesh = Fold(3, 8, 60.0); // the edge runs up the y axis, A before B; z is outside
  const std::vector<FeatureEdge> edges = Find(mesh, 30.0);
  ASSERT_EQ(edges.size(), 8u);
  for (const FeatureEdge& edge : edges)
  {
    EXPECT_LT(Corners(mesh, edge.Left).Centroid().x(), 0.0);
    EXPECT_GT(Corners(mesh, edge.Right).Centroid().x(), 0.0);
  }
}

TEST(FeatureEdges, NonManifoldOnesOnlyIfWanted)
{
  FeatureCriteria criteria = PlainCriteria(30.0);
  EXPECT_EQ(Select(Wings(3), criteria).size(), 1u);
  criteria.NonManifold = false;
  EXPECT_TRUE(Select(Wings(3), criteria).empty());
}

TEST(FeatureEdges, AreNotFoldedBackMoreThanTheLargestAngle)
{
  FeatureCriteria criteria = PlainCriteria(30.0);
  criteria.Band.Largest = 100.0;
  EXPECT_EQ(Select(Fold(3, 8, 90.0), criteria).size(), 8u);
  EXPECT_TRUE(Select(Fold(3, 8, 110.0), criteria).empty());
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

TEST(FeatureEdges, AThinTriangleLiesInThePlaneAcrossItsLongestEdge)
{
  // A sliver between the two sides of a fold, its tip off the edge by next to nothing, but upwards.
  Mesh mesh = Fold(1, 1, 90.0); // edge from 1 to 4
  const Index tip = mesh.VertexCount();
  mesh.Points.push_back(0.5 * (mesh.Points[1] + mesh.Points[4]) + Vec3(0.0, 0.0, 1e-9));
  for (Triangle& triangle : mesh.Triangles)
  {
    const bool hasEdge = std::count(triangle.begin(), triangle.end(), 1) > 0 &&
      std::count(triangle.begin(), triangle.end(), 4) > 0;
    if (hasEdge &&
      std::count(triangle.begin(), triangle.end(), 0) +
          std::count(triangle.begin(), triangle.end(), 3) >
        0)
    {
      // The left one now goes over the tip: two triangles, and the sliver beside.
      const Index other = std::count(triangle.begin(), triangle.end(), 0) > 0 ? 0 : 3;
      triangle = { other, 1, tip };
      mesh.Triangles.push_back({ other, tip, 4 });
      mesh.Triangles.push_back({ 1, 4, tip });
      break;
    }
  }
  const std::vector<FeatureEdge> edges = Find(mesh, 30.0);
  ASSERT_EQ(edges.size(), 2u) << "round the sliver, not on both its sides";
  for (const FeatureEdge& edge : edges)
  {
    EXPECT_EQ(edge.B, tip);
    EXPECT_NEAR(edge.DihedralAngle, 90.0, AngleRounding);
  }
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

TEST(FeatureEdges, AreTheSameHoweverFlatTheSteepOnesMayBe)
{
  Mesh mesh = Noisy(Sphere(5.0, 12), 0.1);
  Append(mesh, Wings(3));
  Append(mesh, FlatGrid(4, 4));
  std::swap(mesh.Triangles[40][0], mesh.Triangles[40][1]);
  const Connectivity connectivity(mesh);
  const Folds all = FindFolds(mesh, connectivity, Monitor());
  const Folds steep = FindFolds(mesh, connectivity, Monitor(), DifferenceOfAngle(15.0));
  EXPECT_LT(steep.Steep.size(), all.Steep.size());
  const std::vector<FeatureEdge> expected = CandidateEdges(mesh, connectivity, all, 20.0);
  const std::vector<FeatureEdge> edges = CandidateEdges(mesh, connectivity, steep, 20.0);
  ASSERT_EQ(edges.size(), expected.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    EXPECT_EQ(edges[i].A, expected[i].A);
    EXPECT_EQ(edges[i].B, expected[i].B);
  }
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(FoldSize(mesh, connectivity, all, t, k),
        std::abs(FoldAt(mesh, connectivity, all, t, k).Difference));
    }
  }
}

TEST(FeatureEdges, GiveNothingWhenStopped)
{
  const Mesh mesh = Box(2, 2, 2);
  std::vector<FeatureEdge> edges;
  const Connectivity connectivity(mesh);
  const Monitor stopped([](double) { return false; });
  EXPECT_TRUE(FindFolds(mesh, connectivity, stopped).Normals.empty());
  EXPECT_FALSE(SelectFeatures(mesh, connectivity, FindFolds(mesh, connectivity, Monitor()),
    PlainCriteria(30.0), stopped, edges));
  EXPECT_TRUE(edges.empty());
}
