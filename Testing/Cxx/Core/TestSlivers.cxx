// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Features/Slivers.h"

#include "Features.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Columns = 30;

/// A plate whose edges are marked as features by hand, with any angle.
class Plate
{
public:
  Plate()
    : Surface(FlatGrid(Columns, Columns))
    , Adjacency(Surface)
    , EdgeFolds(FindFolds(Surface, Adjacency, Monitor()))
  {
  }

  void Mark(Index a, Index b, double angle)
  {
    const FeatureEdge* known = FindFeature(this->Edges, a, b);
    if (known == nullptr)
    {
      this->Edges.push_back(
        MakeFeatureBetween(this->Surface, this->Adjacency, this->EdgeFolds, a, b));
      this->Edges.back().DihedralAngle = angle;
      SortEdges(this->Edges);
    }
  }

  void MarkAround(Index triangle, double angle)
  {
    const Triangle& corners = this->Surface.Triangles[triangle];
    for (int k = 0; k < 3; ++k)
    {
      this->Mark(corners[k], corners[Next(k)], angle);
    }
  }

  /// Marks the line in the middle, across all of the plate.
  void MarkLine(double angle)
  {
    std::vector<Index> line;
    for (Index v = 0; v < this->Surface.VertexCount(); ++v)
    {
      if (this->Surface.Points[v].x() == Columns / 2)
      {
        line.push_back(v);
      }
    }
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      this->Mark(line[i], line[i + 1], angle);
    }
  }

  /// A triangle in the middle of the plate with an edge on that line.
  Index BesideLine() const
  {
    const auto onLine = [this](Index v) { return this->Surface.Points[v].x() == Columns / 2; };
    for (Index t = this->Surface.TriangleCount() / 2; t < this->Surface.TriangleCount(); ++t)
    {
      const Triangle& corners = this->Surface.Triangles[t];
      if (std::count_if(corners.begin(), corners.end(), onLine) == 2)
      {
        return t;
      }
    }
    return NoIndex;
  }

  bool Drop()
  {
    return DropSlivers(
      this->Surface, FindSurfaces(this->Surface, this->Adjacency, this->Edges), this->Edges);
  }

  Mesh Surface;
  Connectivity Adjacency;
  Folds EdgeFolds;
  std::vector<FeatureEdge> Edges;
};
}

TEST(Slivers, WithinAFaceBelongToIt)
{
  Plate plate;
  plate.MarkAround(plate.BesideLine(), 40.0);
  ASSERT_EQ(plate.Edges.size(), 3U);
  EXPECT_TRUE(plate.Drop());
  EXPECT_TRUE(plate.Edges.empty());
  EXPECT_FALSE(plate.Drop());
}

TEST(Slivers, ThatLieTogetherBelongThereTogether)
{
  Plate plate;
  const Index triangle = plate.BesideLine();
  plate.MarkAround(triangle, 40.0);
  plate.MarkAround(plate.Adjacency.AcrossEdge[triangle][0], 70.0);
  ASSERT_EQ(plate.Edges.size(), 5U);
  EXPECT_TRUE(plate.Drop());
  EXPECT_TRUE(plate.Edges.empty());
}

TEST(Slivers, BesideAnEdgeBelongToTheFlatterSide)
{
  Plate plate;
  plate.MarkLine(90.0);
  const std::vector<std::array<Index, 2>> line = EndsOf(plate.Edges);
  plate.MarkAround(plate.BesideLine(), 44.0);
  ASSERT_EQ(plate.Edges.size(), Columns + 2U);
  EXPECT_TRUE(plate.Drop());
  EXPECT_EQ(EndsOf(plate.Edges), line);
}

TEST(Slivers, AreNotWhatFoldsAlikeToAllSides)
{
  Plate plate;
  plate.MarkLine(90.0);
  plate.MarkAround(plate.BesideLine(), 80.0);
  EXPECT_FALSE(plate.Drop());
  EXPECT_EQ(plate.Edges.size(), Columns + 2U);
}

TEST(Slivers, MayHaveEdgesTwiceAsLong)
{
  Plate plate;
  const Index triangle = plate.BesideLine();
  plate.MarkAround(triangle, 40.0);
  const Triangle& corners = plate.Surface.Triangles[triangle];
  const Vec3 middle = Corners(plate.Surface, triangle).Centroid();
  for (const Index v : corners)
  {
    plate.Surface.Points[v] = middle + 1.9 * (plate.Surface.Points[v] - middle);
  }
  EXPECT_TRUE(plate.Drop());
  Plate larger;
  larger.MarkAround(triangle, 40.0);
  for (const Index v : corners)
  {
    larger.Surface.Points[v] = middle + 2.2 * (larger.Surface.Points[v] - middle);
  }
  EXPECT_FALSE(larger.Drop());
}

TEST(Slivers, AreNotFoundOnCoarseMeshes)
{
  const Mesh box = Box(1, 1, 1);
  std::vector<FeatureEdge> edges = FeaturesAbove(box, 30.0);
  edges.front().DihedralAngle = 31.0;
  EXPECT_FALSE(DropSlivers(box, FindSurfaces(box, Connectivity(box), edges), edges));
  EXPECT_EQ(edges.size(), 12U);
}

TEST(Slivers, AreNotOnTheBoundary)
{
  Plate plate;
  plate.MarkAround(0, 40.0); // in the plate's corner
  EXPECT_FALSE(plate.Drop());
}
