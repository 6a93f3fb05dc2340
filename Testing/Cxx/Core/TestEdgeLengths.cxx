// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/EdgeLengths.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
Mesh RightTriangle()
{
  Mesh mesh;
  mesh.Points = { Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 4, 0), Vec3(9, 9, 9) };
  mesh.Triangles = { { 2, 0, 1 } };
  return mesh;
}
}

TEST(EdgeLengths, OfNothingAreNone)
{
  const Mesh mesh;
  EXPECT_EQ(AverageEdgeLength(mesh, Connectivity(mesh)), 0.0);
  EXPECT_EQ(GeometricMeanEdgeLength(mesh, Connectivity(mesh)), 0.0);
}

TEST(EdgeLengths, OfOneTriangle)
{
  const Mesh mesh = RightTriangle();
  EXPECT_DOUBLE_EQ(AverageEdgeLength(mesh, Connectivity(mesh)), 4.0) << "sides 3, 4 and 5";
  EXPECT_DOUBLE_EQ(GeometricMeanEdgeLength(mesh, Connectivity(mesh)), std::cbrt(60.0));
}

TEST(EdgeLengths, CountSharedEdgesOnce)
{
  const Mesh mesh = FlatGrid(1, 1);
  EXPECT_DOUBLE_EQ(
    AverageEdgeLength(mesh, Connectivity(mesh)), (4.0 + std::sqrt(2.0)) / 5.0); // and a diagonal
  EXPECT_DOUBLE_EQ(GeometricMeanEdgeLength(mesh, Connectivity(mesh)), std::pow(2.0, 0.1));
}

TEST(EdgeLengths, WithoutLengthCountInTheAverageAlone)
{
  Mesh mesh = RightTriangle();
  mesh.Points[2] = mesh.Points[0];
  EXPECT_DOUBLE_EQ(AverageEdgeLength(mesh, Connectivity(mesh)), 2.0) << "3, 3 and 0";
  EXPECT_DOUBLE_EQ(GeometricMeanEdgeLength(mesh, Connectivity(mesh)), 3.0);
  mesh.Points[1] = mesh.Points[0];
  EXPECT_EQ(AverageEdgeLength(mesh, Connectivity(mesh)), 0.0);
  EXPECT_EQ(GeometricMeanEdgeLength(mesh, Connectivity(mesh)), 0.0);
}
