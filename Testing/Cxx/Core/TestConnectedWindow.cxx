// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/ConnectedWindow.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

TEST(ConnectedWindow, HoldsAllTrianglesInReachOfAPlane)
{
  // In a plane every triangle within the radius is reached inside it: the window is a disc.
  const Mesh mesh = FlatGrid(9, 9);
  const Connectivity connectivity(mesh);
  ConnectedWindow window(mesh, connectivity);
  for (const double radius : { 0.1, 0.5, 1.0, 1.7, 3.0, 20.0 })
  {
    for (const Index vertex : { 0, 44, 55, 99 })
    {
      EXPECT_EQ(Sorted(window.Gather(vertex, radius)), TrianglesWithin(mesh, vertex, radius))
        << "vertex " << vertex << ", radius " << radius;
    }
  }
}

TEST(ConnectedWindow, BeginsWithTheVertexsOwnTriangles)
{
  const Mesh mesh = FlatGrid(4, 4);
  const Connectivity connectivity(mesh);
  ConnectedWindow window(mesh, connectivity);
  const std::vector<Index> own = ToVector(connectivity.TrianglesOfVertex[12]);
  EXPECT_EQ(window.Gather(12, 0.0), own) << "and holds no others at radius 0";
  const std::vector<Index>& wide = window.Gather(12, 2.0);
  ASSERT_GT(wide.size(), own.size());
  EXPECT_TRUE(std::equal(own.begin(), own.end(), wide.begin()));
}

TEST(ConnectedWindow, DoesNotSeeAWallThatIsNearButFarAlongTheSurface)
{
  // A sheet folded like a U: its sides are 0.5 apart, and 12 or more along the surface.
  std::vector<Vec3> profile;
  for (Index i = 0; i <= 6; ++i)
  {
    profile.emplace_back(0.0, 0.0, 6.0 - i);
  }
  for (Index i = 0; i <= 6; ++i)
  {
    profile.emplace_back(0.5, 0.0, i);
  }
  const Mesh mesh = Extrude(profile, 4, Vec3(0.0, 1.0, 0.0));
  const Connectivity connectivity(mesh);
  const Index top = 2 * static_cast<Index>(profile.size()); // upper end of the left side, half way
  ConnectedWindow window(mesh, connectivity);
  for (const Index t : window.Gather(top, 1.0))
  {
    EXPECT_EQ(Corners(mesh, t).Centroid().x(), 0.0) << "triangle " << t << " is on the other side";
  }
  EXPECT_GT(TrianglesWithin(mesh, top, 1.0).size(), window.Gather(top, 1.0).size())
    << "the other side is within the radius in space";
}

TEST(ConnectedWindow, NextDistanceLeadsToTheNearestTriangleLeftOut)
{
  const Mesh mesh = FlatGrid(8, 8);
  const Connectivity connectivity(mesh);
  ConnectedWindow window(mesh, connectivity);
  window.Gather(40, 0.5); // the centre: beyond its star the nearest triangles touch the star's rim
  const double next = window.NextDistance();
  EXPECT_DOUBLE_EQ(next, std::sqrt(0.5)) << "the middle of the two diagonals opposite the vertex";
  const std::size_t before = window.Gather(40, next * (1.0 - 1e-12)).size();
  EXPECT_GT(window.Gather(40, next * (1.0 + 1e-12)).size(), before);
}

TEST(ConnectedWindow, NextDistanceIsInfiniteWhenNothingIsLeft)
{
  Mesh mesh = FlatGrid(2, 2);
  Append(mesh, FlatGrid(2, 2)); // another part in the same place is not connected
  const Connectivity connectivity(mesh);
  ConnectedWindow window(mesh, connectivity);
  EXPECT_EQ(window.Gather(4, 10.0).size(), 8u);
  EXPECT_TRUE(std::isinf(window.NextDistance()));
}

TEST(ConnectedWindow, GoesOnAllSidesOfANonManifoldEdge)
{
  const Mesh mesh = Wings(5);
  const Connectivity connectivity(mesh);
  ConnectedWindow window(mesh, connectivity);
  EXPECT_EQ(window.Gather(2, 3.0).size(), 5u) << "from the tip of one wing";
}

TEST(ConnectedWindow, SeesPointsThatMovedBetweenTwoCalls)
{
  Mesh mesh = FlatGrid(4, 4);
  const Connectivity connectivity(mesh);
  ConnectedWindow window(mesh, connectivity);
  const std::size_t before = window.Gather(12, 1.2).size();
  mesh.Points[12].z() = 1.1; // all but the vertex's own triangles are now farther than 1.2
  EXPECT_LT(window.Gather(12, 1.2).size(), before);
  EXPECT_EQ(window.Gather(12, 1.2).size(), 6u);
}

TEST(ConnectedWindow, RemembersNothingFromOneVertexToTheNext)
{
  const Mesh mesh = Torus(3.0, 1.0, 24, 12);
  const Connectivity connectivity(mesh);
  ConnectedWindow reused(mesh, connectivity);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    ConnectedWindow fresh(mesh, connectivity);
    EXPECT_EQ(reused.Gather(v, 1.0), fresh.Gather(v, 1.0));
    EXPECT_EQ(reused.NextDistance(), fresh.NextDistance());
  }
}
