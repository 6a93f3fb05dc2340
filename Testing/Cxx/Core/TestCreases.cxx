// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Creases.h"

#include "Core/Geometry.h"

#include "Meshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace arris;
using namespace arris::testing;

namespace
{
double CreasesAt(const Mesh& mesh, Index vertex)
{
  return CreasesAround(mesh.Triangles, Connectivity(mesh), mesh.Points, vertex);
}

double CreasesOf(const Mesh& mesh)
{
  const Connectivity connectivity(mesh);
  double sum = 0.0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    sum += CreasesAround(mesh.Triangles, connectivity, mesh.Points, v);
  }
  return sum;
}

Mesh RegularTetrahedron(double edge)
{
  const double a = edge / std::sqrt(8.0);
  Mesh mesh;
  mesh.Points = { { a, a, a }, { a, -a, -a }, { -a, a, -a }, { -a, -a, a } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  return mesh;
}
}

TEST(Creases, OfATetrahedronAreItsSixEdges)
{
  const double edge = 3.0;
  const double turn = Pi - std::acos(1.0 / 3.0);
  const Mesh mesh = RegularTetrahedron(edge);
  for (Index v = 0; v < 4; ++v)
  {
    EXPECT_NEAR(CreasesAt(mesh, v), 6.0 * edge * std::sqrt(turn), 1e-12);
  }
}

TEST(Creases, OfAFlatMeshAreNone)
{
  EXPECT_EQ(CreasesOf(FlatGrid(6, 5)), 0.0);
}

TEST(Creases, AreFewerWhereOneEdgeHasTheWholeTurn)
{
  for (const double angle : { 30.0, 90.0, 150.0 })
  {
    EXPECT_LT(CreasesOf(Fold(6, 8, angle)), 0.95 * CreasesOf(ChamferedFold(6, 8, angle, 0.5)))
      << angle;
  }
}

TEST(Creases, GrowWithTheUnitOfLengthAlone)
{
  Mesh mesh = Fold(6, 8, 60.0);
  const double before = CreasesOf(mesh);
  for (Vec3& p : mesh.Points)
  {
    p *= 1000.0;
  }
  // The root makes 1e-8 of the rounding in flat edges, which turn by 1e-16.
  EXPECT_NEAR(CreasesOf(mesh), 1000.0 * before, 1000.0 * 1e-6 * before);
}

TEST(Creases, AreThoseOfTheMeshWithTheVertexMoved)
{
  Mesh mesh = Fold(4, 4, 60.0);
  const Connectivity connectivity(mesh);
  const Mesh before = mesh;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    const Vec3 at = before.Points[v] + Vec3(0.1, -0.2, 0.3);
    mesh.Points[v] = at;
    EXPECT_EQ(CreasesAround(before.Triangles, connectivity, before.Points, v, at),
      CreasesAround(mesh.Triangles, connectivity, mesh.Points, v));
    mesh.Points[v] = before.Points[v];
  }
}
