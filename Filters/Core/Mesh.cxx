// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh.h"

#include "Parallel.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace arris
{
namespace
{
/// Room for one row a vertex, of the lengths counted by `lengths`.
std::vector<Index> OffsetsFromLengths(const std::vector<Index>& lengths)
{
  std::vector<Index> offsets(lengths.size() + 1, 0);
  std::partial_sum(lengths.begin(), lengths.end(), offsets.begin() + 1);
  return offsets;
}

Rows CollectTrianglesOfVertex(const Mesh& mesh)
{
  std::vector<Index> lengths(mesh.Points.size(), 0);
  for (const Triangle& triangle : mesh.Triangles)
  {
    for (Index vertex : triangle)
    {
      ++lengths[vertex];
    }
  }
  Rows rows;
  rows.Offsets = OffsetsFromLengths(lengths);
  rows.Values.resize(3 * mesh.Triangles.size());
  std::vector<Index> next(rows.Offsets.begin(), rows.Offsets.end() - 1);
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (Index vertex : mesh.Triangles[t])
    {
      rows.Values[next[vertex]++] = t; // ascending, as t is
    }
  }
  return rows;
}

/// Writes the vertices that share a triangle with `vertex`, ascending, each once, to where there is
/// room for two a triangle; how many there are.
Index GatherNeighbors(const Mesh& mesh, IndexSpan triangles, Index vertex, Index* neighbors)
{
  Index* end = neighbors;
  for (Index t : triangles)
  {
    for (Index other : mesh.Triangles[t])
    {
      if (other != vertex)
      {
        *end++ = other;
      }
    }
  }
  std::sort(neighbors, end);
  return static_cast<Index>(std::unique(neighbors, end) - neighbors);
}

Rows CollectNeighborsOfVertex(const Mesh& mesh, const Rows& trianglesOfVertex)
{
  std::vector<Index> lengths(mesh.Points.size());
  const auto room = std::unique_ptr<Index[]>(new Index[2 * trianglesOfVertex.Values.size()]);
  const auto roomOf = [&](Index v)
  { return room.get() + 2 * static_cast<std::size_t>(trianglesOfVertex.Offsets[v]); };
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        lengths[v] = GatherNeighbors(mesh, trianglesOfVertex[v], v, roomOf(v));
      }
    });
  Rows rows;
  rows.Offsets = OffsetsFromLengths(lengths);
  rows.Values.resize(rows.Offsets.back());
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        std::copy_n(roomOf(v), lengths[v], rows.Values.begin() + rows.Offsets[v]);
      }
    });
  return rows;
}

bool Contains(const Triangle& triangle, Index vertex)
{
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

/// The triangle that follows `t` in ascending order among those on edge (a, b), the first one after
/// the last; NoIndex if `t` is alone there. `count` becomes the number of triangles on the edge.
Index NextAroundEdge(
  const Mesh& mesh, const Rows& trianglesOfVertex, Index t, Index a, Index b, int& count)
{
  // Look through the shorter row: the spokes of a fan of n triangles would else cost n squared.
  if (trianglesOfVertex[b].size() < trianglesOfVertex[a].size())
  {
    std::swap(a, b);
  }
  Index first = NoIndex;
  Index following = NoIndex;
  count = 0;
  for (Index candidate : trianglesOfVertex[a])
  {
    if (Contains(mesh.Triangles[candidate], b))
    {
      ++count;
      if (first == NoIndex)
      {
        first = candidate;
      }
      if (candidate > t && following == NoIndex)
      {
        following = candidate;
      }
    }
  }
  if (count == 1)
  {
    return NoIndex;
  }
  return following == NoIndex ? first : following;
}
}

Connectivity::Connectivity(const Mesh& mesh)
  : TrianglesOfVertex(CollectTrianglesOfVertex(mesh))
  , NeighborsOfVertex(CollectNeighborsOfVertex(mesh, this->TrianglesOfVertex))
  , AcrossEdge(mesh.Triangles.size())
  , OnBoundary(mesh.Points.size(), 0)
{
  // Each triangle marks its own three corners only in `open`; the vertices gather the marks after.
  std::vector<unsigned char> open(mesh.Triangles.size(), 0);
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const Triangle& triangle = mesh.Triangles[t];
        for (int k = 0; k < 3; ++k)
        {
          int count = 0;
          this->AcrossEdge[t][k] =
            NextAroundEdge(mesh, this->TrianglesOfVertex, t, triangle[k], triangle[Next(k)], count);
          if (count != 2)
          {
            open[t] |= static_cast<unsigned char>((1 << k) | (1 << Next(k)));
          }
        }
      }
    });
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        for (Index t : this->TrianglesOfVertex[v])
        {
          if (open[t] & (1 << CornerOf(mesh.Triangles[t], v)))
          {
            this->OnBoundary[v] = 1;
          }
        }
      }
    });
}

double AverageEdgeLength(const Mesh& mesh, const Connectivity& connectivity)
{
  // Summed in the order of storage: a sum by threads would depend on their number.
  double sum = 0.0;
  std::size_t count = 0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    for (Index neighbor : connectivity.NeighborsOfVertex[v])
    {
      if (neighbor > v)
      {
        sum += (mesh.Points[neighbor] - mesh.Points[v]).norm();
        ++count;
      }
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}
}
