// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/FineBends.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace arris;

namespace
{
/// A row of right triangles with legs 1, then of ones with legs 3, which share no vertex.
Mesh SmallAndLarge(int count)
{
  Mesh mesh;
  for (int k = 0; k < 2 * count; ++k)
  {
    const double leg = k < count ? 1.0 : 3.0;
    const Index first = mesh.VertexCount();
    mesh.Points.insert(mesh.Points.end(),
      { Vec3(4.0 * k, 0.0, 0.0), Vec3(4.0 * k + leg, 0.0, 0.0), Vec3(4.0 * k, leg, 0.0) });
    mesh.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return mesh;
}

constexpr int Count = 4;

Flags RegionOf(const Mesh& mesh, Index end)
{
  Flags region(mesh.Points.size(), 0);
  std::fill(region.begin(), region.begin() + end, 1);
  return region;
}
}

TEST(BendTriangleSize, IsOfTheTrianglesInsideByThoseOutside)
{
  const Mesh mesh = SmallAndLarge(Count);
  EXPECT_DOUBLE_EQ(BendTriangleSize(mesh, RegionOf(mesh, 3 * Count)), 1.0 / 9.0);
}

TEST(BendTriangleSize, LeavesOutTrianglesThatAreHalfInside)
{
  const Mesh mesh = SmallAndLarge(Count);
  EXPECT_DOUBLE_EQ(BendTriangleSize(mesh, RegionOf(mesh, 3 * Count + 2)), 1.0 / 9.0);
}

TEST(BendTriangleSize, IsOneWithoutAnInsideOrAnOutside)
{
  const Mesh mesh = SmallAndLarge(Count);
  EXPECT_EQ(BendTriangleSize(mesh, RegionOf(mesh, 0)), 1.0);
  EXPECT_EQ(BendTriangleSize(mesh, RegionOf(mesh, mesh.VertexCount())), 1.0);
}
