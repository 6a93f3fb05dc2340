// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Mesh.h"

#include "Meshes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

using namespace arris;
using namespace arris::testing;

namespace
{
/// Vertices - edges + triangles: 2 for a sphere, 0 for a torus.
Index EulerCharacteristic(const Mesh& mesh)
{
  const Connectivity connectivity(mesh);
  const Index edges = static_cast<Index>(connectivity.NeighborsOfVertex.Values.size()) / 2;
  return mesh.VertexCount() - edges + mesh.TriangleCount();
}

std::size_t BoundaryVertices(const Mesh& mesh)
{
  const Connectivity connectivity(mesh);
  return std::accumulate(
    connectivity.OnBoundary.begin(), connectivity.OnBoundary.end(), std::size_t(0));
}
}

TEST(Connectivity, OfNothing)
{
  const Mesh mesh;
  const Connectivity connectivity(mesh);
  EXPECT_EQ(connectivity.TrianglesOfVertex.size(), 0);
  EXPECT_EQ(connectivity.NeighborsOfVertex.size(), 0);
}

TEST(Connectivity, OfOneTriangle)
{
  Mesh mesh;
  mesh.Points = { Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 4, 0), Vec3(9, 9, 9) };
  mesh.Triangles = { { 2, 0, 1 } };
  const Connectivity connectivity(mesh);
  EXPECT_EQ(ToVector(connectivity.NeighborsOfVertex[0]), (std::vector<Index>{ 1, 2 }));
  EXPECT_EQ(ToVector(connectivity.TrianglesOfVertex[2]), std::vector<Index>{ 0 });
  EXPECT_EQ(connectivity.AcrossEdge[0], (std::array<Index, 3>{ NoIndex, NoIndex, NoIndex }));
  EXPECT_EQ(connectivity.OnBoundary, (Flags{ 1, 1, 1, 0 }));
  EXPECT_TRUE(connectivity.TrianglesOfVertex[3].empty()) << "vertex 3 is in no triangle";
  EXPECT_TRUE(connectivity.NeighborsOfVertex[3].empty());
}

TEST(Connectivity, OfAGridVertex)
{
  const Mesh mesh = FlatGrid(4, 4); // 5 vertices a row; diagonals from (0, 0) to (1, 1)
  const Connectivity connectivity(mesh);
  EXPECT_EQ(
    ToVector(connectivity.NeighborsOfVertex[12]), (std::vector<Index>{ 6, 7, 11, 13, 17, 18 }));
  EXPECT_EQ(connectivity.TrianglesOfVertex[12].size(), 6);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    const bool rim = v % 5 == 0 || v % 5 == 4 || v / 5 == 0 || v / 5 == 4;
    EXPECT_EQ(connectivity.OnBoundary[v] != 0, rim) << "vertex " << v;
  }
}

TEST(Connectivity, RowsAscend)
{
  const Mesh mesh = Torus(3.0, 1.0, 12, 8);
  const Connectivity connectivity(mesh);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    for (const Rows* rows : { &connectivity.NeighborsOfVertex, &connectivity.TrianglesOfVertex })
    {
      const std::vector<Index> row = ToVector((*rows)[v]);
      EXPECT_TRUE(std::is_sorted(row.begin(), row.end()));
      EXPECT_EQ(std::set<Index>(row.begin(), row.end()).size(), row.size()) << "named twice";
      EXPECT_EQ(row.size(), 6u) << "a regular torus";
    }
  }
}

TEST(Connectivity, AcrossEdgeLeadsToTheOtherTriangleOfTheEdgeAndBack)
{
  const Mesh mesh = Box(3, 2, 4);
  const Connectivity connectivity(mesh);
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index other = connectivity.AcrossEdge[t][k];
      ASSERT_NE(other, NoIndex);
      ASSERT_NE(other, t);
      const Triangle& triangle = mesh.Triangles[other];
      const int corner = CornerOf(triangle, mesh.Triangles[t][Next(k)]);
      EXPECT_EQ(triangle[Next(corner)], mesh.Triangles[t][k]) << "the same edge, the other way";
      EXPECT_EQ(connectivity.AcrossEdge[other][corner], t);
    }
  }
}

TEST(Connectivity, OfFansOfAnySizeHoweverTheyAreWound)
{
  for (Index size = 3; size <= 20; ++size)
  {
    Mesh mesh; // two pyramids on one another; their tips are the last two points
    mesh.Points.resize(static_cast<std::size_t>(size) + 2);
    for (Index i = 0; i < size; ++i)
    {
      const Index step = size % 7 == 0 ? 1 : 7; // not in order
      const Index a = i * step % size;
      const Index b = (i + 1) * step % size;
      mesh.Triangles.push_back({ a, b, size });
      mesh.Triangles.push_back({ b, a, size + 1 });
    }
    for (const bool turned : { false, true })
    {
      if (turned)
      {
        std::swap(mesh.Triangles[2][0], mesh.Triangles[2][1]);
      }
      const Connectivity connectivity(mesh);
      EXPECT_EQ(BoundaryVertices(mesh), 0u);
      EXPECT_EQ(EulerCharacteristic(mesh), 2);
      std::vector<Index> rim(static_cast<std::size_t>(size));
      std::iota(rim.begin(), rim.end(), 0);
      EXPECT_EQ(ToVector(connectivity.NeighborsOfVertex[size]), rim);
      for (Index t = 0; t < mesh.TriangleCount(); ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Index a = mesh.Triangles[t][k];
          const Index b = mesh.Triangles[t][Next(k)];
          const Index other = connectivity.AcrossEdge[t][k];
          ASSERT_NE(other, NoIndex);
          const Triangle& triangle = mesh.Triangles[other];
          const int there = EdgeBetween(triangle, a, b);
          EXPECT_TRUE(std::minmax(triangle[there], triangle[Next(there)]) == std::minmax(a, b));
          EXPECT_EQ(connectivity.AcrossEdge[other][there], t);
        }
      }
    }
  }
}

TEST(Connectivity, DoesNotAskHowTrianglesAreWound)
{
  Mesh mesh = FlatGrid(1, 1);
  std::swap(mesh.Triangles[1][0], mesh.Triangles[1][1]);
  const Connectivity connectivity(mesh);
  const std::array<Index, 3>& across = connectivity.AcrossEdge[0];
  EXPECT_EQ(std::count(across.begin(), across.end(), 1), 1);
}

TEST(Connectivity, ClosedSurfacesHaveNoBoundaryAndTheirEulerCharacteristic)
{
  EXPECT_EQ(BoundaryVertices(Box(4, 3, 2)), 0u);
  EXPECT_EQ(EulerCharacteristic(Box(4, 3, 2)), 2);
  EXPECT_EQ(BoundaryVertices(Torus(3.0, 1.0, 9, 7)), 0u);
  EXPECT_EQ(EulerCharacteristic(Torus(3.0, 1.0, 9, 7)), 0);
  EXPECT_EQ(BoundaryVertices(Tube(1.0, 8, 3, 1.0)), 16u) << "two rims of eight";
}

TEST(Connectivity, GoesRoundANonManifoldEdge)
{
  const Mesh mesh = Wings(5);
  const Connectivity connectivity(mesh);
  std::set<Index> visited;
  Index t = 2;
  do
  {
    visited.insert(t);
    t = connectivity.AcrossEdge[t][0];
    ASSERT_NE(t, NoIndex);
  } while (t != 2 && visited.size() < 6);
  EXPECT_EQ(visited.size(), 5u);
}

TEST(Connectivity, EndsOfANonManifoldEdgeAreOnTheBoundaryOfTheirPatches)
{
  // Three closed tetrahedra glued along the edge from 0 to 1: no open edge, but six triangles on
  // one edge.
  Mesh mesh;
  mesh.Points = { Vec3(0, 0, 0), Vec3(0, 0, 1) };
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 2.0 * Pi * i / 3.0;
    const Index a = mesh.VertexCount();
    mesh.Points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
    mesh.Points.emplace_back(std::cos(angle + 0.5), std::sin(angle + 0.5), 0.5);
    for (const Triangle& t : { Triangle{ 0, 1, a }, Triangle{ 0, a + 1, 1 },
           Triangle{ 0, a, a + 1 }, Triangle{ 1, a + 1, a } })
    {
      mesh.Triangles.push_back(t);
    }
  }
  EXPECT_EQ(Connectivity(mesh).OnBoundary, (Flags{ 1, 1, 0, 0, 0, 0, 0, 0 }));
}

TEST(Connectivity, TrianglesThatShareOnlyAVertexAreNotAcrossAnEdge)
{
  Mesh mesh;
  mesh.Points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0) };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 3, 4 } };
  const Connectivity connectivity(mesh);
  EXPECT_EQ(connectivity.AcrossEdge[0], (std::array<Index, 3>{ NoIndex, NoIndex, NoIndex }));
  EXPECT_EQ(connectivity.NeighborsOfVertex[0].size(), 4);
}
