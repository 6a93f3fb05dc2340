// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Features.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

// Hysteresis, gaps and tails; noise has a file of its own.

namespace
{
double LengthOfEdges(const Mesh& mesh, const std::vector<FeatureEdge>& edges)
{
  double length = 0.0;
  for (const FeatureEdge& edge : edges)
  {
    length += (mesh.Points[edge.B] - mesh.Points[edge.A]).norm();
  }
  return length;
}

/// Rows are so much longer than columns are wide that nothing folds across but the edge itself.
constexpr double RowLength = 50.0;

/// A fold along y whose angle in row i is angles[i].
Mesh FoldOfAngles(const std::vector<double>& angles)
{
  constexpr Index Width = 3;
  Mesh mesh = FlatGrid(2 * Width, static_cast<Index>(angles.size()) - 1);
  for (Vec3& point : mesh.Points)
  {
    const double angle = angles[static_cast<std::size_t>(point.y())];
    point.y() *= RowLength;
    point.x() -= Width;
    point.z() = -std::abs(point.x()) * std::tan(0.5 * angle * Pi / 180.0);
  }
  return mesh;
}
}

TEST(FeatureSelection, AnEdgeThatFadesEndsWhereItFades)
{
  // 60 degrees at y = 0, 0 at y = 48: 30 degrees are at 24, 15 at 36. The angle between two rows is
  // that half way between them, to within a degree.
  const Mesh mesh = FadingFold(6, 60, 60.0, 48.0);
  FeatureCriteria criteria = PlainCriteria(30.0);
  EXPECT_NEAR(LengthOfEdges(mesh, Select(mesh, criteria)), 24.0, 1.1);
  criteria.Band.Continuation = 15.0;
  criteria.GapLength = 1.2;
  criteria.TailLength = 2.4;
  const std::vector<FeatureEdge> edges = Select(mesh, criteria);
  EXPECT_NEAR(LengthOfEdges(mesh, edges), 36.0, 1.1);
  for (const FeatureEdge& edge : edges)
  {
    EXPECT_EQ(mesh.Points[edge.A].x(), 0.0);
    EXPECT_EQ(mesh.Points[edge.B].x(), 0.0);
  }
}

TEST(FeatureSelection, NothingBelowTheUpperAngleStartsAnEdge)
{
  FeatureCriteria criteria = PlainCriteria(30.0);
  criteria.Band.Continuation = 10.0;
  EXPECT_TRUE(Select(Fold(3, 8, 29.0), criteria).empty());
  EXPECT_EQ(Select(Fold(3, 8, 31.0), criteria).size(), 8u);
}

TEST(FeatureSelection, ExpectedEdgesNeedTheLowerAngleAlone)
{
  const Mesh mesh = Fold(3, 8, 20.0);
  FeatureCriteria criteria = PlainCriteria(30.0);
  criteria.Band.Continuation = 15.0;
  criteria.Likely.assign(mesh.Points.size(), 0);
  EXPECT_TRUE(Select(mesh, criteria).empty());
  for (Index row = 0; row < 5; ++row)
  {
    criteria.Likely[7 * row + 3] = 1;
  }
  EXPECT_EQ(Select(mesh, criteria).size(), 8u) << "four edges, and those that go on from there";
  criteria.Band.Continuation = 25.0;
  EXPECT_TRUE(Select(mesh, criteria).empty());
}

TEST(FeatureSelection, ClosesGapsUpToTheLength)
{
  std::vector<double> angles(21, 60.0);
  angles[10] = 0.0; // the edges before and after it fold by half of 60 degrees
  const Mesh mesh = FoldOfAngles(angles);
  FeatureCriteria criteria = PlainCriteria(50.0);
  const auto rows = [&] { return LengthOfEdges(mesh, Select(mesh, criteria)) / RowLength; };
  EXPECT_NEAR(rows(), 18.0, 1e-12);
  criteria.GapLength = 1.9 * RowLength;
  EXPECT_NEAR(rows(), 18.0, 1e-12);
  criteria.GapLength = 2.1 * RowLength;
  EXPECT_NEAR(rows(), 20.0, 1e-12);
  EXPECT_EQ(JoinEdges(EndsOf(Select(mesh, criteria)), mesh.Points).Curves.size(), 1u);
}

TEST(FeatureSelection, AnEndWithNothingAheadStays)
{
  const Mesh mesh = FadingFold(6, 60, 60.0, 48.0);
  FeatureCriteria criteria = PlainCriteria(30.0);
  const std::size_t before = Select(mesh, criteria).size();
  criteria.GapLength = 5.0; // the end of the edge is 24 from the border
  EXPECT_EQ(Select(mesh, criteria).size(), before);
}

TEST(FeatureSelection, CutsTailsShorterThanTheLength)
{
  std::vector<double> angles(21, 0.0);
  angles[10] = angles[11] = angles[12] = 60.0;
  const Mesh mesh = FoldOfAngles(angles); // an edge of two rows by itself
  FeatureCriteria criteria = PlainCriteria(50.0);
  EXPECT_EQ(Select(mesh, criteria).size(), 2u);
  criteria.TailLength = 1.9 * RowLength;
  EXPECT_EQ(Select(mesh, criteria).size(), 2u);
  criteria.TailLength = 2.1 * RowLength;
  EXPECT_TRUE(Select(mesh, criteria).empty());
}

TEST(FeatureSelection, TailsHaveAFreeEnd)
{
  FeatureCriteria criteria = PlainCriteria(30.0);
  criteria.TailLength = 100.0;
  EXPECT_EQ(Select(Box(1, 2, 3), criteria).size(), 24u) << "none has";
  criteria.TailLength = 0.0;
  criteria.MinimumLength = 1.5; // the four edges of length 1 go; of the loops that leaves, none
  const std::vector<FeatureEdge> edges = Select(Box(1, 2, 3), criteria);
  EXPECT_EQ(edges.size(), 20u);
}

TEST(FeatureSelection, WhatEndsOnTheBoundaryEndsNotFreely)
{
  FeatureCriteria criteria = PlainCriteria(30.0);
  criteria.TailLength = 100.0;
  EXPECT_EQ(Select(Fold(3, 8, 60.0), criteria).size(), 8u);
}

TEST(FeatureSelection, TheBoundaryIsNeverATail)
{
  FeatureCriteria criteria = PlainCriteria(30.0);
  criteria.Boundary = true;
  criteria.TailLength = criteria.MinimumLength = 100.0;
  EXPECT_EQ(Select(FlatGrid(3, 3), criteria).size(), 12u);
}
