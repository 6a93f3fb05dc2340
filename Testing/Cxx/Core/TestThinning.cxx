// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Thinning.h"

#include "Meshes.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

using namespace arris;
using namespace arris::testing;

namespace
{
/// A mesh, a region on it, and what thinning makes of the region.
struct Thinned
{
  Mesh TheMesh;
  Connectivity TheConnectivity;
  Flags Region;
  std::vector<double> Priority;
  std::vector<int> Rounds;

  Thinned(const Mesh& mesh, const std::function<bool(const Vec3&)>& inRegion,
    std::vector<double> priority = {})
    : TheMesh(mesh)
    , TheConnectivity(mesh)
    , Priority(std::move(priority))
  {
    for (const Vec3& point : mesh.Points)
    {
      this->Region.push_back(inRegion(point) ? 1 : 0);
    }
    this->Rounds =
      ThinningRounds(this->TheMesh, this->TheConnectivity, this->Region, this->Priority, Monitor());
  }

  int LastRound() const { return *std::max_element(this->Rounds.begin(), this->Rounds.end()); }

  Flags Skeleton() const
  {
    Flags skeleton;
    for (const int round : this->Rounds)
    {
      skeleton.push_back(round != NeverSharp && round == this->LastRound() ? 1 : 0);
    }
    return skeleton;
  }

  std::vector<Index> SharpNeighbors(const Flags& region, Index v) const
  {
    std::vector<Index> sharp;
    for (const Index n : this->TheConnectivity.NeighborsOfVertex[v])
    {
      if (region[n])
      {
        sharp.push_back(n);
      }
    }
    return sharp;
  }

  bool Linked(Index a, Index b) const
  {
    const IndexSpan neighbors = this->TheConnectivity.NeighborsOfVertex[a];
    return std::find(neighbors.begin(), neighbors.end(), b) != neighbors.end();
  }

  /// The paper's rule, word for word: Warshall's closure of the adjacency among the sharp
  /// neighbours has no zero; not on the boundary, not a tail, and on the border of the region.
  bool MayLose(const Flags& region, Index v) const
  {
    const std::vector<Index> around = this->SharpNeighbors(region, v);
    const std::size_t n = around.size();
    const bool onBorder = static_cast<Index>(n) < this->TheConnectivity.NeighborsOfVertex[v].size();
    if (!region[v] || !onBorder || this->TheConnectivity.OnBoundary[v] || n < 2)
    {
      return false;
    }
    std::vector<std::vector<bool>> closure(n, std::vector<bool>(n));
    for (std::size_t i = 0; i < n; ++i)
    {
      for (std::size_t j = 0; j < n; ++j)
      {
        closure[i][j] = i == j || this->Linked(around[i], around[j]);
      }
    }
    for (std::size_t k = 0; k < n; ++k)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t j = 0; j < n; ++j)
        {
          closure[i][j] = closure[i][j] || (closure[i][k] && closure[k][j]);
        }
      }
    }
    return std::all_of(closure.begin(), closure.end(),
      [](const std::vector<bool>& row) { return std::count(row.begin(), row.end(), false) == 0; });
  }

  int Components(const Flags& region) const
  {
    Flags left = region;
    int components = 0;
    for (Index seed = 0; seed < this->TheMesh.VertexCount(); ++seed)
    {
      if (!left[seed])
      {
        continue;
      }
      ++components;
      left[seed] = 0;
      std::vector<Index> front(1, seed);
      while (!front.empty())
      {
        const Index v = front.back();
        front.pop_back();
        for (const Index n : this->SharpNeighbors(left, v))
        {
          left[n] = 0;
          front.push_back(n);
        }
      }
    }
    return components;
  }

  /// Vertices - edges + triangles of the part of the mesh that the region spans: components minus
  /// holes.
  int EulerCharacteristic(const Flags& region) const
  {
    int twiceEdges = 0;
    for (Index v = 0; v < this->TheMesh.VertexCount(); ++v)
    {
      twiceEdges += region[v] ? static_cast<int>(this->SharpNeighbors(region, v).size()) : 0;
    }
    const auto triangles =
      std::count_if(this->TheMesh.Triangles.begin(), this->TheMesh.Triangles.end(),
        [&](const Triangle& t) { return region[t[0]] && region[t[1]] && region[t[2]]; });
    return static_cast<int>(std::count(region.begin(), region.end(), 1)) - twiceEdges / 2 +
      static_cast<int>(triangles);
  }

  /// The vertices in the order they went: by round, then priority, then number.
  std::vector<Index> OrderOfRemoval() const
  {
    std::vector<Index> order;
    for (Index v = 0; v < this->TheMesh.VertexCount(); ++v)
    {
      if (this->Region[v] && !this->Skeleton()[v])
      {
        order.push_back(v);
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [&](Index a, Index b)
      {
        return this->Rounds[a] != this->Rounds[b]
          ? this->Rounds[a] < this->Rounds[b]
          : !this->Priority.empty() && this->Priority[a] < this->Priority[b];
      });
    return order;
  }

  /// What is true of every thinning.
  void ExpectRightfulThinning() const
  {
    Flags region = this->Region;
    for (const Index v : this->OrderOfRemoval())
    {
      EXPECT_TRUE(this->MayLose(region, v)) << "vertex " << v << " in round " << this->Rounds[v];
      region[v] = 0;
    }
    EXPECT_EQ(region, this->Skeleton());
    for (Index v = 0; v < this->TheMesh.VertexCount(); ++v)
    {
      EXPECT_EQ(this->Rounds[v] == NeverSharp, this->Region[v] == 0) << "vertex " << v;
      EXPECT_FALSE(this->MayLose(region, v)) << "vertex " << v << " could still go";
    }
    EXPECT_EQ(this->Components(region), this->Components(this->Region));
    EXPECT_EQ(this->EulerCharacteristic(region), this->EulerCharacteristic(this->Region));
  }

  /// How many skeleton vertices have that many skeleton neighbours.
  int CountWithNeighbors(std::size_t neighbors) const
  {
    const Flags skeleton = this->Skeleton();
    int count = 0;
    for (Index v = 0; v < this->TheMesh.VertexCount(); ++v)
    {
      count += skeleton[v] && this->SharpNeighbors(skeleton, v).size() == neighbors ? 1 : 0;
    }
    return count;
  }

  Index SkeletonSize() const
  {
    const Flags skeleton = this->Skeleton();
    return static_cast<Index>(std::count(skeleton.begin(), skeleton.end(), 1));
  }

  bool SkeletonReaches(const Vec3& point, double distance) const
  {
    const Flags skeleton = this->Skeleton();
    for (Index v = 0; v < this->TheMesh.VertexCount(); ++v)
    {
      if (skeleton[v] && (this->TheMesh.Points[v] - point).norm() <= distance)
      {
        return true;
      }
    }
    return false;
  }
};

bool Within(double value, double low, double high)
{
  return value >= low && value <= high;
}
}

TEST(Thinning, OfNoRegionMarksNothing)
{
  const Thinned thinned(FlatGrid(4, 4), [](const Vec3&) { return false; });
  EXPECT_EQ(thinned.Rounds, std::vector<int>(25, NeverSharp));
}

TEST(Thinning, KeepsAVertexAlone)
{
  const Thinned thinned(FlatGrid(4, 4), [](const Vec3& p) { return p == Vec3(2, 2, 0); });
  EXPECT_EQ(thinned.Rounds[12], 1);
  EXPECT_EQ(thinned.SkeletonSize(), 1);
}

TEST(Thinning, KeepsAnEdgeAlone)
{
  const Thinned thinned(
    FlatGrid(5, 5), [](const Vec3& p) { return p.y() == 2.0 && Within(p.x(), 2.0, 3.0); });
  EXPECT_EQ(thinned.SkeletonSize(), 2);
}

TEST(Thinning, LeavesOfAStripItsMiddleLine)
{
  const Thinned thinned(FlatGrid(24, 8),
    [](const Vec3& p) { return Within(p.x(), 2.0, 22.0) && Within(p.y(), 3.0, 5.0); });
  thinned.ExpectRightfulThinning();
  EXPECT_EQ(thinned.CountWithNeighbors(1), 2) << "two tails";
  EXPECT_EQ(thinned.CountWithNeighbors(2), thinned.SkeletonSize() - 2) << "and a line between";
  EXPECT_TRUE(thinned.SkeletonReaches(Vec3(2, 4, 0), 2.0)) << "not eaten from its ends";
  EXPECT_TRUE(thinned.SkeletonReaches(Vec3(22, 4, 0), 2.0));
}

TEST(Thinning, GoesOneRingARound)
{
  // Half the width of the strip and some rounds at its ends.
  const Thinned thin(FlatGrid(24, 12), [](const Vec3& p) { return Within(p.y(), 5.0, 7.0); });
  const Thinned wide(FlatGrid(24, 12), [](const Vec3& p) { return Within(p.y(), 2.0, 10.0); });
  wide.ExpectRightfulThinning();
  EXPECT_LT(thin.LastRound(), wide.LastRound());
  for (Index v = 0; v < wide.TheMesh.VertexCount(); ++v)
  {
    const Vec3& p = wide.TheMesh.Points[v];
    if (Within(p.x(), 8.0, 16.0) && wide.Region[v])
    {
      const int ring = static_cast<int>(std::min(p.y() - 1.0, 11.0 - p.y()));
      EXPECT_GE(wide.Rounds[v], ring) << "no ring goes before the one outside it";
    }
  }
}

TEST(Thinning, OfADiscLeavesNoHole)
{
  const Thinned thinned(
    FlatGrid(20, 20), [](const Vec3& p) { return (p - Vec3(10, 10, 0)).norm() <= 6.0; });
  thinned.ExpectRightfulThinning();
  EXPECT_EQ(thinned.EulerCharacteristic(thinned.Skeleton()), 1);
}

TEST(Thinning, OfAnAnnulusKeepsItsHole)
{
  const Thinned thinned(
    FlatGrid(24, 24), [](const Vec3& p) { return Within((p - Vec3(12, 12, 0)).norm(), 5.0, 9.0); });
  thinned.ExpectRightfulThinning();
  EXPECT_EQ(thinned.EulerCharacteristic(thinned.Skeleton()), 0); // a loop, and tails on it
}

TEST(Thinning, OfABandRoundATubeLeavesAClosedLoop)
{
  const Thinned thinned(
    Tube(3.0, 12, 6, 1.0), [](const Vec3& p) { return Within(p.z(), 2.0, 4.0); });
  thinned.ExpectRightfulThinning();
  EXPECT_EQ(thinned.SkeletonSize(), 12);
  EXPECT_EQ(thinned.CountWithNeighbors(2), 12) << "the middle ring";
}

TEST(Thinning, KeepsEveryHoleOfARegion)
{
  const Thinned thinned(FlatGrid(30, 20),
    [](const Vec3& p)
    {
      return Within(p.x(), 2.0, 28.0) && Within(p.y(), 2.0, 18.0) &&
        (p - Vec3(9, 10, 0)).norm() > 3.0 && p != Vec3(20, 10, 0); // one is a single vertex
    });
  thinned.ExpectRightfulThinning();
  EXPECT_EQ(thinned.EulerCharacteristic(thinned.Skeleton()), -1);
}

TEST(Thinning, KeepsPartsApartAndEachOfThem)
{
  const Thinned thinned(FlatGrid(30, 12),
    [](const Vec3& p)
    {
      return Within(p.y(), 2.0, 4.0) || (p - Vec3(8, 8, 0)).norm() < 2.5 ||
        (p - Vec3(20, 8, 0)).norm() < 1.5;
    });
  thinned.ExpectRightfulThinning();
  EXPECT_EQ(thinned.Components(thinned.Skeleton()), 3);
}

TEST(Thinning, OfATeeLeavesThreeArms)
{
  const Thinned thinned(FlatGrid(24, 24),
    [](const Vec3& p)
    {
      return Within(p.x(), 2.0, 22.0) && Within(p.y(), 11.0, 13.0)
        ? true
        : Within(p.x(), 11.0, 13.0) && Within(p.y(), 13.0, 22.0);
    });
  thinned.ExpectRightfulThinning();
  EXPECT_EQ(thinned.CountWithNeighbors(1), 3) << "three tails";
  for (const Vec3& end : { Vec3(2, 12, 0), Vec3(22, 12, 0), Vec3(12, 22, 0) })
  {
    EXPECT_TRUE(thinned.SkeletonReaches(end, 2.5)) << end.transpose();
  }
}

TEST(Thinning, KeepsTheBoundaryOfTheMesh)
{
  const Thinned thinned(FlatGrid(16, 8), [](const Vec3& p) { return Within(p.y(), 3.0, 5.0); });
  thinned.ExpectRightfulThinning();
  for (Index v = 0; v < thinned.TheMesh.VertexCount(); ++v)
  {
    if (thinned.Region[v] && thinned.TheConnectivity.OnBoundary[v])
    {
      EXPECT_TRUE(thinned.Skeleton()[v]) << thinned.TheMesh.Points[v].transpose();
    }
  }
}

TEST(Thinning, OfAClosedSurfaceSharpAllOverRemovesNothing)
{
  const Thinned thinned(Box(3, 3, 3), [](const Vec3&) { return true; });
  EXPECT_EQ(thinned.Rounds, std::vector<int>(thinned.Rounds.size(), 1)) << "it has no border";
}

TEST(Thinning, OfTheEdgesOfABoxLeavesItsWireFrame)
{
  constexpr double Size = 10.0;
  const Thinned thinned(Box(10, 10, 10),
    [](const Vec3& p)
    {
      int near = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        near += std::min(p[axis], Size - p[axis]) <= 1.0 ? 1 : 0;
      }
      return near > 1;
    });
  thinned.ExpectRightfulThinning();
  EXPECT_EQ(thinned.EulerCharacteristic(thinned.Skeleton()), -4) << "8 corners, 12 edges";
}

TEST(Thinning, TriesTheLeastPriorityFirst)
{
  // Of two rows the one of less priority goes, whichever is stored first.
  const auto rows = [](const Vec3& p)
  { return Within(p.x(), 2.0, 10.0) && Within(p.y(), 3.0, 4.0); };
  for (const bool upperFirst : { false, true })
  {
    const Mesh mesh = FlatGrid(12, 8);
    std::vector<double> priority;
    for (const Vec3& p : mesh.Points)
    {
      priority.push_back(upperFirst ? -p.y() : p.y());
    }
    const Thinned thinned(mesh, rows, priority);
    thinned.ExpectRightfulThinning();
    const double kept = upperFirst ? 3.0 : 4.0;
    for (Index v = 0; v < mesh.VertexCount(); ++v)
    {
      if (thinned.Skeleton()[v] && Within(mesh.Points[v].x(), 4.0, 8.0))
      {
        EXPECT_EQ(mesh.Points[v].y(), kept);
      }
    }
  }
}

TEST(Thinning, GivesNothingWhenStopped)
{
  const Mesh mesh = FlatGrid(8, 8);
  const Connectivity connectivity(mesh);
  Flags region(mesh.Points.size(), 1);
  region[0] = 0;
  EXPECT_TRUE(
    ThinningRounds(mesh, connectivity, region, {}, Monitor([](double) { return false; })).empty());
}
