// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh.h"

#include "ClosedFan.h"
#include "Parallel.h"
#include "SortUnique.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace arris
{
namespace
{
/// Room for one row a vertex, of the lengths counted by `lengths`.
std::vector<Index> OffsetsFromLengths(const Unfilled<Index>& lengths)
{
  std::vector<Index> offsets(lengths.size() + 1, 0);
  std::partial_sum(lengths.begin(), lengths.end(), offsets.begin() + 1);
  return offsets;
}

Rows CollectTrianglesOfVertex(const Mesh& mesh)
{
  // Each row's length is counted two places on; the sums up to there are where the row before
  // begins, and are moved on to its end as it fills.
  Rows rows;
  rows.Offsets.assign(mesh.Points.size() + 2, 0);
  for (const Triangle& triangle : mesh.Triangles)
  {
    for (Index vertex : triangle)
    {
      ++rows.Offsets[vertex + 2];
    }
  }
  std::partial_sum(rows.Offsets.begin(), rows.Offsets.end(), rows.Offsets.begin());
  rows.Values.resize(3 * mesh.Triangles.size());
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (Index vertex : mesh.Triangles[t])
    {
      rows.Values[rows.Offsets[vertex + 1]++] = t; // ascending, as t is
    }
  }
  rows.Offsets.pop_back();
  return rows;
}

/// The edges at one vertex, told from its triangles. Keeps its working memory from one vertex to
/// the next: one object a thread.
class Spokes
{
public:
  void Gather(const Mesh& mesh, IndexSpan triangles, Index vertex)
  {
    this->Leaving.resize(triangles.size());
    this->Arriving.resize(triangles.size());
    for (Index i = 0; i < triangles.size(); ++i)
    {
      const Index t = triangles[i];
      const Triangle& triangle = mesh.Triangles[t];
      const int corner = CornerOf(triangle, vertex);
      const int last = Next(Next(corner));
      this->Leaving[i] = Side(triangle[Next(corner)], t, corner);
      this->Arriving[i] = Side(triangle[last], t, last);
    }
    Sort(this->Leaving);
    Sort(this->Arriving);
  }

  /// Calls visit(neighbor, sides, count) for each edge, by ascending neighbour, with its sides by
  /// ascending triangle.
  template <typename Visit>
  void ForEachEdge(Visit&& visit)
  {
    if (this->IsClosed())
    {
      for (std::size_t i = 0; i < this->Leaving.size(); ++i)
      {
        const auto pair = std::minmax(this->Leaving[i], this->Arriving[i]);
        const std::uint64_t sides[2] = { pair.first, pair.second };
        visit(NeighborOf(sides[0]), sides, 2);
      }
      return;
    }
    this->All.resize(this->Leaving.size() + this->Arriving.size());
    std::merge(this->Leaving.begin(), this->Leaving.end(), this->Arriving.begin(),
      this->Arriving.end(), this->All.begin());
    for (std::size_t first = 0, last = 0; first < this->All.size(); first = last)
    {
      while (last < this->All.size() && NeighborOf(this->All[last]) == NeighborOf(this->All[first]))
      {
        ++last;
      }
      visit(NeighborOf(this->All[first]), &this->All[first], static_cast<int>(last - first));
    }
  }

  static Index TriangleOf(std::uint64_t side) { return static_cast<Index>(Slot(side) / 3); }
  static int EdgeOf(std::uint64_t side) { return static_cast<int>(Slot(side) % 3); }

private:
  // A side is an edge as one triangle has it: the neighbour, then the place among all triangles'
  // edges, in one number that sorts by both.
  static std::uint64_t Side(Index neighbor, Index triangle, int edge)
  {
    return (static_cast<std::uint64_t>(neighbor) << 32) |
      (3 * static_cast<std::uint32_t>(triangle) + static_cast<std::uint32_t>(edge));
  }
  /// Few edges are sorted fastest by insertion.
  static void Sort(std::vector<std::uint64_t>& sides)
  {
    constexpr std::size_t Few = 16;
    if (sides.size() > Few)
    {
      std::sort(sides.begin(), sides.end());
      return;
    }
    for (std::size_t i = 1; i < sides.size(); ++i)
    {
      const std::uint64_t side = sides[i];
      std::size_t to = i;
      for (; to > 0 && sides[to - 1] > side; --to)
      {
        sides[to] = sides[to - 1];
      }
      sides[to] = side;
    }
  }
  static std::uint32_t Slot(std::uint64_t side) { return static_cast<std::uint32_t>(side); }
  static Index NeighborOf(std::uint64_t side) { return static_cast<Index>(side >> 32); }

  /// Whether each edge has two triangles, wound alike: then one leaves the vertex by it and the
  /// other arrives.
  bool IsClosed() const
  {
    for (std::size_t i = 0; i < this->Leaving.size(); ++i)
    {
      const Index neighbor = NeighborOf(this->Leaving[i]);
      if (neighbor != NeighborOf(this->Arriving[i]) ||
        (i > 0 && neighbor == NeighborOf(this->Leaving[i - 1])))
      {
        return false;
      }
    }
    return true;
  }

  std::vector<std::uint64_t> Leaving, Arriving, All;
};

/// Makes each side of an edge point to the triangle of the next, the last one to the first.
void LinkAround(const std::uint64_t* sides, int count, Unfilled<std::array<Index, 3>>& acrossEdge)
{
  for (int i = 0; i < count; ++i)
  {
    const std::uint64_t next = sides[i + 1 < count ? i + 1 : 0];
    acrossEdge[Spokes::TriangleOf(sides[i])][Spokes::EdgeOf(sides[i])] =
      count > 1 ? Spokes::TriangleOf(next) : NoIndex;
  }
}

/// Makes room for `lengths` in the rows of neighbours. A row that is as long as that of the
/// triangles is where it belongs if all are, as on a closed mesh; the others are gathered anew.
void SpreadNeighbors(
  const Mesh& mesh, const Rows& trianglesOfVertex, const Unfilled<Index>& lengths, Rows& neighbors)
{
  std::vector<Index> offsets = OffsetsFromLengths(lengths);
  if (offsets == trianglesOfVertex.Offsets)
  {
    neighbors.Offsets = std::move(offsets);
    return;
  }
  Unfilled<Index> values(offsets.back());
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      Spokes spokes;
      for (Index v = begin; v < end; ++v)
      {
        Index* to = values.data() + offsets[v];
        const IndexSpan triangles = trianglesOfVertex[v];
        if (lengths[v] <= triangles.size())
        {
          std::copy_n(neighbors.Values.data() + trianglesOfVertex.Offsets[v], lengths[v], to);
          continue;
        }
        spokes.Gather(mesh, triangles, v);
        spokes.ForEachEdge([&](Index neighbor, const std::uint64_t*, int) { *to++ = neighbor; });
      }
    });
  neighbors.Offsets = std::move(offsets);
  neighbors.Values = std::move(values);
}
}

Connectivity::Connectivity(const Mesh& mesh)
  : TrianglesOfVertex(CollectTrianglesOfVertex(mesh))
  , AcrossEdge(mesh.Triangles.size())
  , OnBoundary(mesh.Points.size(), 0)
{
  Unfilled<Index> lengths(mesh.Points.size());
  this->NeighborsOfVertex.Values.resize(this->TrianglesOfVertex.Values.size());
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      ClosedFan fan;
      Spokes spokes; // for those that are none
      for (Index v = begin; v < end; ++v)
      {
        const IndexSpan triangles = this->TrianglesOfVertex[v];
        Index* neighbors =
          this->NeighborsOfVertex.Values.data() + this->TrianglesOfVertex.Offsets[v];
        if (fan.Gather(mesh, triangles, v))
        {
          fan.ForEachEdge(
            [&](Index i, Index j, Index neighbor, Index rank)
            {
              if (v < neighbor) // or both ends would
              {
                this->AcrossEdge[triangles[i]][fan.LeavingEdge(i)] = triangles[j];
                this->AcrossEdge[triangles[j]][fan.ArrivingEdge(j)] = triangles[i];
              }
              neighbors[rank] = neighbor;
            });
          lengths[v] = triangles.size();
          continue;
        }
        Index count = 0;
        bool closed = true;
        spokes.Gather(mesh, triangles, v);
        spokes.ForEachEdge(
          [&](Index neighbor, const std::uint64_t* sides, int sideCount)
          {
            if (v < neighbor)
            {
              LinkAround(sides, sideCount, this->AcrossEdge);
            }
            if (count < triangles.size())
            {
              neighbors[count] = neighbor;
            }
            ++count;
            closed = closed && sideCount == 2;
          });
        lengths[v] = count;
        this->OnBoundary[v] = closed ? 0 : 1;
      }
    });
  SpreadNeighbors(mesh, this->TrianglesOfVertex, lengths, this->NeighborsOfVertex);
}

bool HasBoundary(const Connectivity& connectivity)
{
  const Flags& flags = connectivity.OnBoundary;
  return std::find(flags.begin(), flags.end(), 1) != flags.end();
}

std::vector<Index> TrianglesAround(
  const Connectivity& connectivity, const std::vector<Index>& vertices)
{
  std::vector<Index> triangles;
  for (Index v : vertices)
  {
    const IndexSpan around = connectivity.TrianglesOfVertex[v];
    triangles.insert(triangles.end(), around.begin(), around.end());
  }
  SortUnique(triangles);
  return triangles;
}

Flags OpenVertices(const Mesh& mesh, const Connectivity& connectivity)
{
  Flags open(mesh.Points.size(), 0);
  const bool any = HasBoundary(connectivity);
  for (Index t = 0; any && t < mesh.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (connectivity.AcrossEdge[t][k] == NoIndex)
      {
        open[mesh.Triangles[t][k]] = open[mesh.Triangles[t][Next(k)]] = 1;
      }
    }
  }
  return open;
}

void RingOfEdge(
  const Mesh& mesh, const Connectivity& connectivity, Index t, int k, std::vector<Index>& ring)
{
  const Index a = mesh.Triangles[t][k];
  const Index b = mesh.Triangles[t][Next(k)];
  ring.assign(1, t);
  for (Index next = connectivity.AcrossEdge[t][k]; next != NoIndex && next != t;
       next = connectivity.AcrossEdge[next][EdgeBetween(mesh.Triangles[next], a, b)])
  {
    ring.push_back(next);
  }
}
}
