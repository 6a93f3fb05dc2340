// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Overturned.h"

#include <gtest/gtest.h>

using namespace arris;

namespace
{
/// Two triangles on the x axis: the first goes up to `first` and is asked about, the second, to
/// `second`, does not move.
bool IsTurnedOver(const Vec3& first, const Vec3& firstNow, const Vec3& second)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, first, second };
  mesh.Triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
  std::vector<Vec3> now = mesh.Points;
  now[2] = firstNow;
  return IsOverturned(mesh, Connectivity(mesh), now, 0);
}

const Vec3 Left(0.5, 1.0, 0.0);
const Vec3 Right(0.5, -1.0, 0.0);
const Vec3 AlmostRight(0.5, -0.9, 0.05);
const Vec3 RightAndUp(0.5, -0.5, 0.5);
const Vec3 Down(0.5, -0.5, -1.0);
}

TEST(Overturned, IsATriangleThatLiesOnItsNeighbour)
{
  EXPECT_TRUE(IsTurnedOver(Left, AlmostRight, Right));
}

TEST(Overturned, IsNotWhatLayThereBefore)
{
  EXPECT_FALSE(IsTurnedOver(AlmostRight, { 0.5, -0.9, 0.06 }, Right));
}

TEST(Overturned, IsATriangleThatFacesAgainstAllNearIt)
{
  EXPECT_TRUE(IsTurnedOver(Left, RightAndUp, Right));
}

TEST(Overturned, IsNotATriangleThatTurnsToTheFaceBesideIt)
{
  // By more than a right angle: the faces of an acute edge are that far apart.
  EXPECT_FALSE(IsTurnedOver(Left, { 0.5, -0.2, 0.5 }, Down));
}

TEST(Overturned, IsNotWhatStays)
{
  EXPECT_FALSE(IsTurnedOver(Left, Left, Right));
}
