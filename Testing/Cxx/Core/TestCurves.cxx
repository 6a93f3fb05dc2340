// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Curves.h"

#include "Features.h"

#include <gtest/gtest.h>

#include <set>

using namespace arris;
using namespace arris::testing;

namespace
{
using Edges = std::vector<std::array<Index, 2>>;

const CurveSplits NoTurns;

/// Points one unit apart on the x axis.
std::vector<Vec3> Line(Index count)
{
  std::vector<Vec3> points;
  points.reserve(count);
  for (Index i = 0; i < count; ++i)
  {
    points.emplace_back(i, 0.0, 0.0);
  }
  return points;
}

/// The outline of a square of 2 units in 8 edges: corners 0, 2, 4 and 6.
const std::vector<Vec3> SquarePoints = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0),
  Vec3(2, 2, 0), Vec3(1, 2, 0), Vec3(0, 2, 0), Vec3(0, 1, 0) };
const Edges SquareEdges = { { 0, 1 }, { 0, 7 }, { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 5 }, { 5, 6 },
  { 6, 7 } };
}

TEST(Curves, OfNoEdges)
{
  const CurveNetwork network = JoinEdges({}, {}, { 60.0 });
  EXPECT_TRUE(network.Curves.empty());
  EXPECT_TRUE(network.Corners.empty());
}

TEST(Curves, JoinEdgesEndToEnd)
{
  const CurveNetwork network =
    JoinEdges({ { 1, 2 }, { 3, 4 }, { 0, 1 }, { 2, 3 } }, Line(5), { 60.0 });
  ASSERT_EQ(network.Curves.size(), 1u);
  EXPECT_EQ(network.Curves[0], (Curve{ 0, 1, 2, 3, 4 }));
  ASSERT_EQ(network.Corners.size(), 2u);
  EXPECT_EQ(network.Corners[0].Vertex, 0);
  EXPECT_EQ(network.Corners[0].Valence, 1);
  EXPECT_EQ(network.Corners[1].Vertex, 4);
}

TEST(Curves, AClosedOneNamesItsFirstVertexAgain)
{
  const CurveNetwork network = JoinEdges(SquareEdges, SquarePoints, NoTurns);
  ASSERT_EQ(network.Curves.size(), 1u);
  EXPECT_EQ(network.Curves[0], (Curve{ 0, 1, 2, 3, 4, 5, 6, 7, 0 }));
  EXPECT_TRUE(network.Corners.empty());
}

TEST(Curves, AreSplitWhereTheyTurn)
{
  const CurveNetwork network = JoinEdges(SquareEdges, SquarePoints, { 60.0 });
  EXPECT_EQ(
    network.Curves, (std::vector<Curve>{ { 0, 1, 2 }, { 0, 7, 6 }, { 2, 3, 4 }, { 4, 5, 6 } }));
  ASSERT_EQ(network.Corners.size(), 4u);
  for (const CurveCorner& corner : network.Corners)
  {
    EXPECT_EQ(corner.Vertex % 2, 0);
    EXPECT_EQ(corner.Valence, 2) << "a turn";
  }
}

TEST(Curves, TurnOnlyByMoreThanTheAngle)
{
  EXPECT_EQ(JoinEdges(SquareEdges, SquarePoints, { 89.0 }).Curves.size(), 4u);
  EXPECT_EQ(JoinEdges(SquareEdges, SquarePoints, { 91.0 }).Curves.size(), 1u);
}

TEST(Curves, EndWhereThreeMeet)
{
  std::vector<Vec3> points = Line(5);
  points.emplace_back(2.0, 1.0, 0.0);
  const CurveNetwork network =
    JoinEdges({ { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 }, { 2, 5 } }, points, NoTurns);
  EXPECT_EQ(network.Curves, (std::vector<Curve>{ { 0, 1, 2 }, { 2, 3, 4 }, { 2, 5 } }));
  ASSERT_EQ(network.Corners.size(), 4u);
  EXPECT_EQ(network.Corners[1].Vertex, 2);
  EXPECT_EQ(network.Corners[1].Valence, 3);
}

TEST(Curves, ALoopThatHangsOnACornerComesBackToIt)
{
  Edges edges = SquareEdges;
  std::vector<Vec3> points = SquarePoints;
  points.emplace_back(-1.0, 0.0, 0.0);
  edges.push_back({ 0, 8 });
  const CurveNetwork network = JoinEdges(edges, points, NoTurns);
  EXPECT_EQ(network.Curves, (std::vector<Curve>{ { 0, 1, 2, 3, 4, 5, 6, 7, 0 }, { 0, 8 } }));
}

TEST(Curves, ClosedOnesComeAfterThoseBetweenCorners)
{
  Edges edges = SquareEdges; // a loop from vertex 0 on
  std::vector<Vec3> points = SquarePoints;
  points.emplace_back(5.0, 0.0, 0.0);
  points.emplace_back(6.0, 0.0, 0.0);
  edges.push_back({ 8, 9 });
  const CurveNetwork network = JoinEdges(edges, points, NoTurns);
  ASSERT_EQ(network.Curves.size(), 2u);
  EXPECT_EQ(network.Curves[0], (Curve{ 8, 9 }));
  EXPECT_EQ(network.Curves[1].front(), network.Curves[1].back());
}

TEST(Curves, OfABoxAreItsTwelveEdges)
{
  const Mesh mesh = Box(3, 4, 5);
  const Edges edges = EndsOf(FeaturesAbove(mesh, 30.0));
  const CurveNetwork network = JoinEdges(edges, mesh.Points, { 60.0 });
  EXPECT_EQ(network.Curves.size(), 12u);
  ASSERT_EQ(network.Corners.size(), 8u);
  std::set<std::pair<Index, Index>> used;
  for (const Curve& curve : network.Curves)
  {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
    {
      EXPECT_TRUE(used.insert(std::minmax(curve[i], curve[i + 1])).second) << "used twice";
    }
  }
  EXPECT_EQ(used.size(), edges.size());
  for (const CurveCorner& corner : network.Corners)
  {
    EXPECT_EQ(corner.Valence, 3);
  }
}

TEST(Curves, AKinkOfATinyEdgeIsNoTurnWithinReach)
{
  // One unit a step along x, but for a step of a tenth aside.
  std::vector<Vec3> points = Line(10);
  for (std::size_t i = 5; i < points.size(); ++i)
  {
    points[i] += Vec3(-1.0, 0.1, 0.0);
  }
  Edges edges;
  for (Index i = 0; i + 1 < 10; ++i)
  {
    edges.push_back({ i, i + 1 });
  }
  EXPECT_EQ(JoinEdges(edges, points, { 60.0 }).Curves.size(), 3u) << "two turns by 90 degrees";
  EXPECT_EQ(JoinEdges(edges, points, { 60.0, 1.0, {} }).Curves.size(), 1u);
}

TEST(Curves, ATightArcIsNoTurnHoweverFarTheReach)
{
  std::vector<Vec3> points;
  Edges edges;
  for (Index i = 0; i <= 24; ++i) // half a turn in steps of 7.5 degrees
  {
    points.emplace_back(std::cos(i * Pi / 24.0), std::sin(i * Pi / 24.0), 0.0);
    if (i > 0)
    {
      edges.push_back({ i - 1, i });
    }
  }
  EXPECT_EQ(JoinEdges(edges, points, { 60.0, 2.0, {} }).Curves.size(), 1u);
}

namespace
{
/// A run of edges along points.
Edges RunOf(const std::vector<Vec3>& points)
{
  Edges edges;
  for (Index i = 0; i + 1 < static_cast<Index>(points.size()); ++i)
  {
    edges.push_back({ i, i + 1 });
  }
  return edges;
}
std::size_t CurvesOf(const std::vector<Vec3>& points, bool forgetKinks)
{
  return JoinEdges(RunOf(points), points, { 60.0, 0.0, {}, forgetKinks }).Curves.size();
}
}

TEST(Curves, AVertexThatStandsOffIsNoCornerWhereKinksAreForgotten)
{
  std::vector<Vec3> points = Line(11);
  points[5].y() = 2.0;
  EXPECT_EQ(CurvesOf(points, false), 4U);
  EXPECT_EQ(CurvesOf(points, true), 1U);
}

TEST(Curves, ATurnForGoodIsACornerThoughKinksAreForgotten)
{
  std::vector<Vec3> points = Line(11);
  for (Index i = 5; i < 11; ++i) // by 90 degrees
  {
    points[i] = Vec3(5.0, i - 5.0, 0.0);
  }
  EXPECT_EQ(CurvesOf(points, true), 2U);
}

TEST(Curves, ACoarseOutlineKeepsItsCornersThoughKinksAreForgotten)
{
  std::vector<Vec3> battlements;
  for (Index i = 0; i < 12; ++i) // up, right, down, right, ...
  {
    battlements.emplace_back(i / 2, (i + 1) / 2 % 2, 0.0);
  }
  EXPECT_EQ(CurvesOf(battlements, true), 11U);
}

TEST(Curves, AKinkJustBeforeAJunctionIsForgotten)
{
  std::vector<Vec3> points = Line(11);
  points[1] += Vec3(0.4, 0.0, 0.0);
  points[2] -= Vec3(0.8, 0.0, 0.0); // doubled back
  points.emplace_back(0.0, 1.0, 0.0);
  points.emplace_back(0.0, -1.0, 0.0);
  Edges edges = RunOf(Line(11));
  edges.push_back({ 0, 11 });
  edges.push_back({ 0, 12 });
  EXPECT_EQ(JoinEdges(edges, points, { 60.0, 0.0, {}, false }).Curves.size(), 5U);
  EXPECT_EQ(JoinEdges(edges, points, { 60.0, 0.0, {}, true }).Curves.size(), 3U);
}

TEST(Curves, AreSplitWhereTheirSortChanges)
{
  const CurveNetwork network =
    JoinEdges({ { 0, 1 }, { 1, 2 }, { 2, 3 } }, Line(4), { 180.0, 0.0, { 7, 7, 8 } });
  EXPECT_EQ(network.Curves, (std::vector<Curve>{ { 0, 1, 2 }, { 2, 3 } }));
}

TEST(Curves, KnowTheirLength)
{
  EXPECT_EQ(LengthOf({ 0, 1, 2 }, Line(3)), 2.0);
  EXPECT_TRUE(IsClosed({ 0, 1, 2, 0 }));
  EXPECT_FALSE(IsClosed({ 0, 1, 2 }));
}
