// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/SpatialWindow.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
/// Compares the window of every vertex with a look at every triangle.
void ExpectAllInReach(const Mesh& mesh, double gridRadius, double radius)
{
  const WindowGrid grid(mesh, gridRadius);
  const Connectivity connectivity(mesh);
  SpatialWindow window(mesh, connectivity, grid);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    // Ascending, as the brute force is.
    ASSERT_EQ(window.Gather(v, radius), TrianglesWithin(mesh, v, radius))
      << "vertex " << v << ", radius " << radius;
  }
}
}

TEST(SpatialWindow, HoldsAllTrianglesInReach)
{
  for (const double radius : { 0.05, 0.4, 1.3, 9.0 })
  {
    ExpectAllInReach(Torus(3.0, 1.0, 24, 12), radius, radius);
    ExpectAllInReach(Box(4, 5, 3), radius, radius);
  }
}

TEST(SpatialWindow, TheRadiusNeedNotBeTheGrids)
{
  ExpectAllInReach(Torus(3.0, 1.0, 24, 12), 0.4, 1.7);
  ExpectAllInReach(Torus(3.0, 1.0, 24, 12), 2.0, 0.3);
}

TEST(SpatialWindow, SeesAWallWhetherOrNotItIsConnected)
{
  Mesh mesh = FlatGrid(6, 6);
  Mesh wall = FlatGrid(6, 6);
  for (Vec3& point : wall.Points)
  {
    point.z() = 0.5;
  }
  const Index first = mesh.TriangleCount();
  Append(mesh, wall);
  const WindowGrid grid(mesh, 1.0);
  const Connectivity connectivity(mesh);
  SpatialWindow window(mesh, connectivity, grid);
  const std::vector<Index>& found = window.Gather(24, 1.0);
  EXPECT_GT(std::count_if(found.begin(), found.end(), [&](Index t) { return t >= first; }), 0);
  EXPECT_EQ(found, TrianglesWithin(mesh, 24, 1.0));
}

TEST(SpatialWindow, FlatAndFarFromTheOrigin)
{
  Mesh mesh = FlatGrid(6, 6); // bounds without thickness
  ExpectAllInReach(mesh, 1.0, 1.0);
  for (Vec3& point : mesh.Points)
  {
    point += Vec3(1e6, -2e6, 3e6);
  }
  ExpectAllInReach(mesh, 1.0, 1.0);
}

TEST(SpatialWindow, ATinyWindowInALargePartKeepsItsMemory)
{
  // Cubes as small as the window would be 10^21 here: it must choose larger ones.
  Mesh mesh = Box(3, 3, 3);
  const WindowGrid grid(mesh, 3e-7);
  const Connectivity connectivity(mesh);
  SpatialWindow window(mesh, connectivity, grid);
  EXPECT_EQ(window.Gather(0, 3e-7), TrianglesWithin(mesh, 0, 3e-7));
}
