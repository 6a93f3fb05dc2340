// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes.h"

#include "Core/EdgeLengths.h"
#include "Core/Picks.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 8;
constexpr Index Rows = 6;

/// Two half planes, cut into unit squares, with `angle` between their normals. Column 0 is on the
/// fold.
class FoldedSheet
{
public:
  explicit FoldedSheet(double angle)
    : TheMesh(Fold(Width, Rows, angle))
    , TheConnectivity(TheMesh)
    , Edge(AverageEdgeLength(TheMesh, TheConnectivity))
  {
  }
  static Index Vertex(Index column) { return Rows / 2 * (2 * Width + 1) + Width + column; }

  FollowedPicks Follow(const Picks& picks, double sharpAngle = 40.0, double ratio = 0.75,
    WindowSearch search = WindowSearch::Connected) const
  {
    return FollowPicks(this->TheMesh, this->TheConnectivity, this->Edge, picks,
      { ratio * this->Edge, sharpAngle, search });
  }
  double Ratio(const FollowedPicks& followed) const
  {
    return followed.Parameters.WindowRadius / this->Edge;
  }
  double AverageEdge() const { return this->Edge; }

  /// Whether a vertex is in the sharp region by these parameters.
  bool IsSharp(Index vertex, const ClassificationParameters& by) const
  {
    return SharpRegion(
      NormalDifferences(this->TheMesh, this->TheConnectivity,
        UnitNormals(this->TheMesh, this->Edge), by.WindowRadius, by.Search, Monitor()),
      by.SharpAngle)[vertex];
  }

private:
  Mesh TheMesh;
  Connectivity TheConnectivity;
  double Edge;
};
}

TEST(Picks, OnTheEdgeTheLeastWindowIsEnoughAndTheAngleIsTheEdges)
{
  const FoldedSheet sheet(90.0);
  for (const WindowSearch search : { WindowSearch::Connected, WindowSearch::Spatial })
  {
    const FollowedPicks followed =
      sheet.Follow({ { { sheet.Vertex(0) } }, {} }, 40.0, 0.75, search);
    EXPECT_EQ(followed.Verdict, PickVerdict::Followed);
    EXPECT_DOUBLE_EQ(sheet.Ratio(followed), LeastPickedRatio);
    EXPECT_NEAR(followed.Parameters.SharpAngle, 90.0, 1e-6);
    EXPECT_EQ(followed.Parameters.Search, search);
    EXPECT_TRUE(sheet.IsSharp(sheet.Vertex(0), followed.Parameters));
  }
}

TEST(Picks, TheWindowGrowsUntilTheFarthestSeesTheEdge)
{
  const FoldedSheet sheet(90.0);
  const Picks picks = { { { sheet.Vertex(0) }, { sheet.Vertex(2) }, { sheet.Vertex(-1) } }, {} };
  const FollowedPicks followed = sheet.Follow(picks);
  ASSERT_EQ(followed.Verdict, PickVerdict::Followed);
  // Column 2 sees the triangles beyond the fold from a distance of 2 on, and not before.
  const double needed = 2.0 / sheet.AverageEdge();
  EXPECT_GE(sheet.Ratio(followed), needed);
  EXPECT_LT(sheet.Ratio(followed), needed + PickedRatioStep);
  for (const Pick& pick : picks.Sharp)
  {
    EXPECT_TRUE(sheet.IsSharp(pick[0], followed.Parameters));
  }
}

TEST(Picks, AShallowEdgeLowersTheAngle)
{
  const FoldedSheet sheet(25.0);
  const FollowedPicks followed = sheet.Follow({ { { sheet.Vertex(1) } }, {} }, 40.0);
  ASSERT_EQ(followed.Verdict, PickVerdict::Followed);
  EXPECT_NEAR(followed.Parameters.SharpAngle, 25.0, 1e-6);
  const double needed = 1.0 / sheet.AverageEdge();
  EXPECT_GE(sheet.Ratio(followed), needed);
  EXPECT_LT(sheet.Ratio(followed), needed + PickedRatioStep); // no larger one sees more
  EXPECT_TRUE(sheet.IsSharp(sheet.Vertex(1), followed.Parameters));
}

TEST(Picks, TheSharpestVertexOfAPickCounts)
{
  const FoldedSheet sheet(90.0);
  const FollowedPicks followed =
    sheet.Follow({ { { sheet.Vertex(5), sheet.Vertex(0), sheet.Vertex(4) } }, {} });
  ASSERT_EQ(followed.Verdict, PickVerdict::Followed);
  EXPECT_DOUBLE_EQ(sheet.Ratio(followed), LeastPickedRatio);
}

TEST(Picks, SmoothOnesAloneShrinkTheWindow)
{
  const FoldedSheet sheet(90.0);
  const Picks picks = { {}, { { sheet.Vertex(2) } } };
  ASSERT_TRUE(sheet.IsSharp(sheet.Vertex(2), { 2.5 * sheet.AverageEdge(), 40.0, {} }));
  const FollowedPicks followed = sheet.Follow(picks, 40.0, 2.5);
  ASSERT_EQ(followed.Verdict, PickVerdict::Followed);
  const double limit = 2.0 / sheet.AverageEdge();
  EXPECT_LT(sheet.Ratio(followed), limit);
  EXPECT_GE(sheet.Ratio(followed), limit - PickedRatioStep); // no farther than needed
  EXPECT_EQ(followed.Parameters.SharpAngle, 40.0);
  EXPECT_FALSE(sheet.IsSharp(sheet.Vertex(2), followed.Parameters));
}

TEST(Picks, SmoothOnesThatAreSmoothChangeNothing)
{
  const FoldedSheet sheet(90.0);
  const FollowedPicks followed = sheet.Follow({ {}, { { sheet.Vertex(5) } } }, 40.0, 0.8);
  EXPECT_DOUBLE_EQ(sheet.Ratio(followed), 0.8);
  EXPECT_EQ(followed.Parameters.SharpAngle, 40.0);
}

TEST(Picks, ASmoothOneOnAShallowEdgeRaisesTheAngle)
{
  const FoldedSheet sheet(50.0);
  const FollowedPicks followed = sheet.Follow({ {}, { { sheet.Vertex(0) } } }, 40.0);
  ASSERT_EQ(followed.Verdict, PickVerdict::Followed);
  EXPECT_NEAR(followed.Parameters.SharpAngle, 50.0, 1e-6);
  EXPECT_FALSE(sheet.IsSharp(sheet.Vertex(0), followed.Parameters));
}

TEST(Picks, SmoothOnesBoundTheWindowOfSharpOnes)
{
  // At the wanted angle column 1 would need a window that column 2 is smooth in: there is one.
  const FoldedSheet sheet(90.0);
  const FollowedPicks followed = sheet.Follow({ { { sheet.Vertex(1) } }, { { sheet.Vertex(2) } } });
  ASSERT_EQ(followed.Verdict, PickVerdict::Followed);
  EXPECT_LT(sheet.Ratio(followed), 2.0 / sheet.AverageEdge());
  EXPECT_TRUE(sheet.IsSharp(sheet.Vertex(1), followed.Parameters));
  EXPECT_FALSE(sheet.IsSharp(sheet.Vertex(2), followed.Parameters));
}

TEST(Picks, ASmoothOneSharperThanASharpOneIsNamed)
{
  const FoldedSheet sheet(90.0);
  const FollowedPicks followed = sheet.Follow(
    { { { sheet.Vertex(0) }, { sheet.Vertex(3) } }, { { sheet.Vertex(6) }, { sheet.Vertex(1) } } },
    40.0, 1.0);
  EXPECT_EQ(followed.Verdict, PickVerdict::Contradictory);
  EXPECT_EQ(followed.Sharp, 1u);
  EXPECT_EQ(followed.Smooth, 1u);
  EXPECT_GE(followed.SmoothDeviation, followed.SharpDeviation);
}

TEST(Picks, TheSameOneCannotBeBoth)
{
  const FoldedSheet sheet(90.0);
  const FollowedPicks followed = sheet.Follow({ { { sheet.Vertex(0) } }, { { sheet.Vertex(0) } } });
  EXPECT_EQ(followed.Verdict, PickVerdict::Contradictory);
}

TEST(Picks, ASharpOneWhereAllIsFlatIsNamed)
{
  const FoldedSheet sheet(90.0);
  const FollowedPicks followed =
    sheet.Follow({ { { sheet.Vertex(0) }, { sheet.Vertex(Width) } }, {} });
  EXPECT_EQ(followed.Verdict, PickVerdict::NotSharp);
  EXPECT_EQ(followed.Sharp, 1u);
}
