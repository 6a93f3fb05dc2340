// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Skeleton.h"

#include "Core/Thinning.h"
#include "Meshes.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace arris;
using namespace arris::testing;

namespace
{
using Edges = std::vector<std::array<Index, 2>>;

/// The skeleton of a mesh on which thinning left these vertices.
Skeleton Trace(const Mesh& mesh, const std::vector<Index>& left)
{
  std::vector<int> rounds(mesh.Points.size(), NeverSharp);
  rounds[0] = 1; // went in the first round
  for (const Index v : left)
  {
    rounds[v] = 2;
  }
  return TraceSkeleton(mesh, Connectivity(mesh), rounds);
}

/// The sharp edges, each once, its lower vertex first, ascending.
Edges EdgesOf(const Skeleton& skeleton)
{
  Edges edges;
  for (Index v = 0; v < skeleton.SharpNeighbors.size(); ++v)
  {
    for (const Index neighbor : skeleton.SharpNeighbors[v])
    {
      if (v < neighbor)
      {
        edges.push_back({ v, neighbor });
      }
    }
  }
  return edges;
}

Index CountRole(const Skeleton& skeleton, SkeletonRole role)
{
  return static_cast<Index>(std::count(skeleton.Roles.begin(), skeleton.Roles.end(), role));
}
}

TEST(Skeleton, OfNothing)
{
  const Mesh mesh = FlatGrid(2, 2);
  const Skeleton skeleton =
    TraceSkeleton(mesh, Connectivity(mesh), std::vector<int>(mesh.Points.size(), NeverSharp));
  EXPECT_TRUE(EdgesOf(skeleton).empty());
  EXPECT_EQ(CountRole(skeleton, SkeletonRole::None), mesh.VertexCount());
}

TEST(Skeleton, OfALineHasBranchesBetweenTwoEnds)
{
  const Mesh mesh = FlatGrid(6, 6); // 7 vertices a row
  const Skeleton skeleton = Trace(mesh, { 22, 23, 24, 25 });
  EXPECT_EQ(EdgesOf(skeleton), (Edges{ { 22, 23 }, { 23, 24 }, { 24, 25 } }));
  EXPECT_EQ(skeleton.Roles[22], SkeletonRole::End);
  EXPECT_EQ(skeleton.Roles[23], SkeletonRole::Branch);
  EXPECT_EQ(skeleton.Roles[25], SkeletonRole::End);
  EXPECT_EQ(skeleton.Roles[0], SkeletonRole::None) << "removed in an earlier round";
  EXPECT_EQ(skeleton.Roles[1], SkeletonRole::None) << "never sharp";
}

TEST(Skeleton, AVertexAloneIsAnEnd)
{
  EXPECT_EQ(Trace(FlatGrid(4, 4), { 12 }).Roles[12], SkeletonRole::End);
}

TEST(Skeleton, ThreeArmsMeetInAJoint)
{
  const Mesh mesh = FlatGrid(8, 8); // 9 vertices a row; centre 40
  const Skeleton skeleton = Trace(mesh, { 38, 39, 40, 50, 60, 31, 22 });
  EXPECT_EQ(skeleton.Roles[40], SkeletonRole::Joint);
  EXPECT_EQ(skeleton.SharpNeighbors[40].size(), 3);
  EXPECT_EQ(CountRole(skeleton, SkeletonRole::End), 3);
  EXPECT_EQ(CountRole(skeleton, SkeletonRole::Branch), 3);
}

TEST(Skeleton, OpensATriangleAtItsGreatestAngle)
{
  // 6, 7 and 12 are the corners of a triangle of the grid; its right angle is at 7.
  const Skeleton skeleton = Trace(FlatGrid(4, 4), { 6, 7, 12 });
  EXPECT_EQ(EdgesOf(skeleton), (Edges{ { 6, 7 }, { 7, 12 } }));
  EXPECT_EQ(skeleton.Roles[7], SkeletonRole::Branch);
}

TEST(Skeleton, TheGreatestAngleIsMeasuredNotGuessed)
{
  // The same triangle with the right angle pulled so that the greatest angle is at 6.
  Mesh mesh = FlatGrid(4, 4);
  mesh.Points[6] += Vec3(0.9, 0.3, 0.0);
  EXPECT_EQ(EdgesOf(Trace(mesh, { 6, 7, 12 })), (Edges{ { 6, 7 }, { 6, 12 } }));
}

TEST(Skeleton, OfEqualAnglesTheLowerVertexCounts)
{
  // An equilateral triangle whose three cosines come out the same to the last bit.
  Mesh mesh;
  mesh.Points = { Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ() };
  mesh.Triangles = { { 1, 2, 3 } };
  EXPECT_EQ(EdgesOf(Trace(mesh, { 1, 2, 3 })), (Edges{ { 1, 2 }, { 1, 3 } }));
  mesh.Triangles = { { 3, 1, 2 } };
  EXPECT_EQ(EdgesOf(Trace(mesh, { 1, 2, 3 })), (Edges{ { 1, 2 }, { 1, 3 } }));
}

TEST(Skeleton, ASquareOfTwoTrianglesLosesItsDiagonal)
{
  const Skeleton skeleton = Trace(FlatGrid(4, 4), { 6, 7, 11, 12 });
  EXPECT_EQ(EdgesOf(skeleton), (Edges{ { 6, 7 }, { 6, 11 }, { 7, 12 }, { 11, 12 } }));
  EXPECT_EQ(CountRole(skeleton, SkeletonRole::Branch), 4);
}

TEST(Skeleton, OpenedTrianglesKeepASkeletonConnected)
{
  // A whole fan about 12: every triangle loses one edge, none of the seven vertices falls off.
  const Skeleton skeleton = Trace(FlatGrid(4, 4), { 6, 7, 11, 12, 13, 17, 18 });
  for (const Index v : { 6, 7, 11, 12, 13, 17, 18 })
  {
    EXPECT_FALSE(skeleton.SharpNeighbors[v].empty()) << "vertex " << v;
  }
}

TEST(Skeleton, ALoopHasNeitherEndNorJoint)
{
  const Mesh mesh = Tube(5.0, 16, 4, 1.0);
  std::vector<Index> ring(16);
  std::iota(ring.begin(), ring.end(), 32);
  const Skeleton skeleton = Trace(mesh, ring);
  EXPECT_EQ(EdgesOf(skeleton).size(), 16u);
  EXPECT_EQ(CountRole(skeleton, SkeletonRole::Branch), 16);
}

TEST(Skeleton, SharpNeighborsAreMutual)
{
  const Mesh mesh = Sphere(5.0, 8);
  std::vector<int> rounds(mesh.Points.size(), NeverSharp);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    rounds[v] = v % 3 == 0 ? 1 : NeverSharp; // an arbitrary set, closures and all
  }
  const Skeleton skeleton = TraceSkeleton(mesh, Connectivity(mesh), rounds);
  Index ends = 0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    for (const Index n : skeleton.SharpNeighbors[v])
    {
      const IndexSpan back = skeleton.SharpNeighbors[n];
      EXPECT_EQ(std::count(back.begin(), back.end(), v), 1);
      ++ends;
    }
  }
  EXPECT_GT(ends, 0);
  EXPECT_EQ(static_cast<Index>(EdgesOf(skeleton).size()) * 2, ends);
}
