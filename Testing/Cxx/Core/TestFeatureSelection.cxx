// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Features/Tails.h"

#include "Features.h"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(FeatureSelection, ExpectedEdgesDoNotLeadAcrossFromOneFeatureToAnother)
{
  // The tip of a box is bent down about the line between two vertices of its edges.
  Mesh mesh = Box(6, 6, 2);
  const auto at = [&](double x, double y)
  {
    return static_cast<Index>(
      std::find(mesh.Points.begin(), mesh.Points.end(), Vec3(x, y, 2.0)) - mesh.Points.begin());
  };
  const std::array<Index, 4> square = { at(5, 5), at(6, 5), at(6, 6), at(5, 6) };
  std::vector<Triangle>& triangles = mesh.Triangles;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&](const Triangle& t)
                    {
                      return std::all_of(t.begin(), t.end(),
                        [&](Index v)
                        { return std::find(square.begin(), square.end(), v) != square.end(); });
                    }),
    triangles.end());
  triangles.push_back({ square[0], square[1], square[3] });
  triangles.push_back({ square[1], square[2], square[3] });
  mesh.Points[square[2]].z() -= std::sqrt(0.5) * std::tan(20.0 * Pi / 180.0);

  FeatureCriteria criteria = PlainCriteria(30.0);
  const std::vector<FeatureEdge> edges = Select(mesh, criteria);
  criteria.Band.Continuation = 15.0;
  criteria.Likely.assign(mesh.Points.size(), 0);
  for (const FeatureEdge& edge : edges)
  {
    criteria.Likely[edge.A] = criteria.Likely[edge.B] = 1;
  }
  EXPECT_EQ(EndsOf(Select(mesh, criteria)), EndsOf(edges));
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

TEST(FeatureSelection, ATailReachesUpToItsNextTurn)
{
  // Ten edges along x from the boundary on, and two along y.
  std::vector<Vec3> points;
  std::vector<FeatureEdge> edges;
  for (Index i = 0; i <= 12; ++i)
  {
    points.emplace_back(std::min(i, 10), std::max(0, i - 10), 0.0);
    if (i > 0)
    {
      edges.push_back({ i - 1, i, 90.0, EdgeKind::Convex, NoIndex, NoIndex });
    }
  }
  Flags onBoundary(points.size(), 0);
  onBoundary[0] = 1;
  FeatureCriteria criteria = PlainCriteria(30.0);
  criteria.TailLength = 1.9;
  CutTails(points, onBoundary, criteria, edges);
  EXPECT_EQ(edges.size(), 12U);
  criteria.TailLength = 2.1;
  CutTails(points, onBoundary, criteria, edges);
  EXPECT_EQ(edges.size(), 10U);
}

TEST(FeatureSelection, TailsAwayFromWhatIsExpectedMustBeLonger)
{
  std::vector<double> angles(21, 0.0);
  angles[9] = angles[10] = angles[11] = angles[12] = 60.0;
  const Mesh mesh = FoldOfAngles(angles); // an edge of three rows by itself
  FeatureCriteria criteria = PlainCriteria(50.0);
  criteria.TailLength = 2.0 * RowLength;
  criteria.UnlikelyLength = 4.0 * RowLength;
  EXPECT_EQ(Select(mesh, criteria).size(), 3u) << "nothing is known of what is expected";
  criteria.Likely.assign(mesh.Points.size(), 1);
  EXPECT_EQ(Select(mesh, criteria).size(), 3u);
  criteria.Likely.assign(mesh.Points.size(), 0);
  EXPECT_TRUE(Select(mesh, criteria).empty());
}

TEST(FeatureSelection, ClosesGapsFartherAwayWhereTheSurfaceFolds)
{
  // One vertex of a fold is pushed in, so that the edges there fold the other way.
  Mesh mesh = Fold(8, 20, 60.0);
  FeatureCriteria criteria = PlainCriteria(50.0);
  const std::size_t whole = Select(mesh, criteria).size();
  for (Vec3& point : mesh.Points)
  {
    point.z() -= point.x() == 0.0 && std::abs(point.y() - 10.0) < 1.5 ? 0.6 : 0.0;
  }
  const auto alongTheFold = [&]
  {
    const std::vector<FeatureEdge> edges = Select(mesh, criteria);
    return std::count_if(edges.begin(), edges.end(),
      [&](const FeatureEdge& e)
      { return mesh.Points[e.A].x() == 0.0 && mesh.Points[e.B].x() == 0.0; });
  };
  EXPECT_LT(alongTheFold(), static_cast<std::ptrdiff_t>(whole));
  criteria.FoldedGapLength = 6.0;
  EXPECT_EQ(alongTheFold(), static_cast<std::ptrdiff_t>(whole));
}

TEST(FeatureSelection, LeavesGapsInWhatIsCurvedAlike)
{
  // Two ridges run towards each other along a cylinder.
  Mesh mesh = Tube(8.0, 50, 24, 1.0); // 7 degrees an edge
  for (Vec3& point : mesh.Points)
  {
    const bool ridge = point.y() == 0.0 && point.x() > 0.0 && std::abs(point.z() - 12.0) > 1.5;
    point.x() += ridge ? 1.5 : 0.0;
  }
  FeatureCriteria criteria = PlainCriteria(70.0);
  criteria.Band.Continuation = 15.0;
  const std::size_t apart = Select(mesh, criteria).size();
  EXPECT_GT(apart, 10U);
  criteria.FoldedGapLength = 6.0;
  EXPECT_EQ(Select(mesh, criteria).size(), apart);
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
