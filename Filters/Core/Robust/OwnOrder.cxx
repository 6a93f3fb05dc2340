// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnOrder.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace arris
{
namespace
{
/// As many bits of three coordinates go into one number.
constexpr int BitsOfCoordinate = 21;

/// Moves the bits of a coordinate three apart.
std::uint64_t Spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffffULL;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
  bits = (bits | bits << 2) & 0x1249249249249249ULL;
  return bits;
}

/// How far along Morton's curve points are, which goes through a cube cell by cell.
class MortonCurve
{
public:
  explicit MortonCurve(const std::vector<Vec3>& points)
  {
    Vec3 high = points.front();
    this->Low = high;
    for (const Vec3& point : points)
    {
      this->Low = this->Low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    this->Width = (high - this->Low).maxCoeff();
  }

  std::uint64_t operator()(const Vec3& point) const
  {
    if (this->Width == 0.0)
    {
      return 0;
    }
    constexpr double Cells = 1 << BitsOfCoordinate;
    std::uint64_t code = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double cell = std::min(Cells * ((point[k] - this->Low[k]) / this->Width), Cells - 1.0);
      code |= Spread(static_cast<std::uint64_t>(cell)) << k;
    }
    return code;
  }

private:
  Vec3 Low;
  double Width;
};

struct Place
{
  std::uint64_t Along; ///< the curve
  Index Vertex;
};

/// What tells vertices of one cell of the curve apart.
class BothVertices
{
public:
  BothVertices(const Mesh& mesh, const Connectivity& connectivity)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
  {
  }

  bool operator()(const Place& a, const Place& b) const
  {
    if (a.Along != b.Along)
    {
      return a.Along < b.Along;
    }
    const Vec3 &p = this->TheMesh.Points[a.Vertex], &q = this->TheMesh.Points[b.Vertex];
    if (p != q)
    {
      return Comparable(p) < Comparable(q);
    }
    const Vec3 around = this->Around(a.Vertex), aroundOther = this->Around(b.Vertex);
    return around != aroundOther ? Comparable(around) < Comparable(aroundOther)
                                 : a.Vertex < b.Vertex;
  }

private:
  static std::tuple<double, double, double> Comparable(const Vec3& p)
  {
    return { p.x(), p.y(), p.z() };
  }

  /// The sum of a vertex's neighbours; on the grid of a frame it is exact.
  Vec3 Around(Index v) const
  {
    Vec3 sum = Vec3::Zero();
    for (Index n : this->TheConnectivity.NeighborsOfVertex[v])
    {
      sum += this->TheMesh.Points[n];
    }
    return sum;
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
};

/// Sorts places: first by their stretch of the curve, then each stretch by itself.
std::vector<Place> Sorted(const std::vector<Place>& places, const BothVertices& before)
{
  constexpr int BitsOfStretch = 15; // a surface goes through some thousands of these
  constexpr int BitsInside = 3 * BitsOfCoordinate - BitsOfStretch;
  std::vector<Index> offsets((1 << BitsOfStretch) + 1, 0);
  for (const Place& place : places)
  {
    ++offsets[(place.Along >> BitsInside) + 1];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<Index> next = offsets;
  std::vector<Place> sorted(places.size());
  for (const Place& place : places)
  {
    sorted[next[place.Along >> BitsInside]++] = place;
  }
  ParallelFor(1 << BitsOfStretch,
    [&](Index begin, Index end)
    {
      for (Index stretch = begin; stretch < end; ++stretch)
      {
        std::sort(sorted.begin() + offsets[stretch], sorted.begin() + offsets[stretch + 1], before);
      }
    });
  return sorted;
}

std::vector<Index> VerticesAlongCurve(const Mesh& mesh, const Connectivity& connectivity)
{
  std::vector<Place> places(mesh.Points.size());
  const MortonCurve curve(mesh.Points);
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        places[v] = { curve(mesh.Points[v]), v };
      }
    });
  places = Sorted(places, BothVertices(mesh, connectivity));
  std::vector<Index> vertices(places.size());
  std::transform(places.begin(), places.end(), vertices.begin(),
    [](const Place& place) { return place.Vertex; });
  return vertices;
}

/// Where each old number has gone.
std::vector<Index> Inverse(const std::vector<Index>& order)
{
  std::vector<Index> newOf(order.size());
  ParallelFor(static_cast<Index>(order.size()),
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        newOf[order[i]] = i;
      }
    });
  return newOf;
}

/// Triangles in the order of their corners. Those whose lowest corner a vertex is are found around
/// it.
std::vector<Index> TrianglesByCorners(const std::vector<Triangle>& triangles,
  const Connectivity& connectivity, const std::vector<Index>& oldVertices)
{
  const auto vertices = static_cast<Index>(oldVertices.size());
  std::vector<Index> offsets(vertices + 1, 0);
  const auto forEachThatStartsAt = [&](Index v, auto&& visit)
  {
    for (Index t : connectivity.TrianglesOfVertex[oldVertices[v]])
    {
      if (triangles[t][0] == v)
      {
        visit(t);
      }
    }
  };
  ParallelFor(vertices,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        forEachThatStartsAt(v, [&](Index) { ++offsets[v + 1]; });
      }
    });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<Index> order(triangles.size());
  ParallelFor(vertices,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        Index* next = order.data() + offsets[v];
        forEachThatStartsAt(v, [&](Index t) { *next++ = t; });
        std::sort(order.data() + offsets[v], next,
          [&](Index a, Index b) { return std::tie(triangles[a], a) < std::tie(triangles[b], b); });
      }
    });
  return order;
}

Rows RenumberedRows(
  const Rows& rows, const std::vector<Index>& order, const std::vector<Index>& numberNow)
{
  Rows renumbered;
  renumbered.Offsets.assign(order.size() + 1, 0);
  for (std::size_t row = 0; row < order.size(); ++row)
  {
    renumbered.Offsets[row + 1] = renumbered.Offsets[row] + rows[order[row]].size();
  }
  renumbered.Values.resize(rows.Values.size());
  ParallelFor(renumbered.size(),
    [&](Index begin, Index end)
    {
      for (Index row = begin; row < end; ++row)
      {
        const IndexSpan old = rows[order[row]];
        Index* const first = renumbered.Values.data() + renumbered.Offsets[row];
        Index* const last = std::transform(
          old.begin(), old.end(), first, [&](Index number) { return numberNow[number]; });
        std::sort(first, last);
      }
    });
  return renumbered;
}

/// Numbers ids anew, by which is met first.
std::vector<Index> ByFirst(std::vector<Index> ids)
{
  std::vector<Index> numberOf;
  Index next = 0;
  for (Index& id : ids)
  {
    numberOf.resize(std::max<std::size_t>(numberOf.size(), id + 1), NoIndex);
    if (numberOf[id] == NoIndex)
    {
      numberOf[id] = next++;
    }
    id = numberOf[id];
  }
  return ids;
}
}

OwnOrder PutInOwnOrder(Mesh& mesh, const Connectivity& connectivity)
{
  OwnOrder order;
  if (mesh.Points.empty())
  {
    return order;
  }
  order.Vertices = VerticesAlongCurve(mesh, connectivity);
  const std::vector<Index> newOf = Inverse(order.Vertices);
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        Triangle& corners = mesh.Triangles[t];
        std::transform(
          corners.begin(), corners.end(), corners.begin(), [&](Index v) { return newOf[v]; });
        std::rotate(
          corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      }
    });
  order.Triangles = TrianglesByCorners(mesh.Triangles, connectivity, order.Vertices);
  mesh.Points = InOrder(order.Vertices, mesh.Points);
  mesh.Triangles = InOrder(order.Triangles, mesh.Triangles);
  return order;
}

Connectivity Renumbered(const Connectivity& connectivity, const std::vector<Triangle>& before,
  const OwnOrder& order, const std::vector<Triangle>& after)
{
  const std::vector<Index> vertexNow = Inverse(order.Vertices);
  const std::vector<Index> triangleNow = Inverse(order.Triangles);
  Connectivity renumbered;
  renumbered.TrianglesOfVertex =
    RenumberedRows(connectivity.TrianglesOfVertex, order.Vertices, triangleNow);
  renumbered.NeighborsOfVertex =
    RenumberedRows(connectivity.NeighborsOfVertex, order.Vertices, vertexNow);
  renumbered.OnBoundary = InOrder(order.Vertices, connectivity.OnBoundary);
  renumbered.AcrossEdge.resize(after.size());
  ParallelFor(static_cast<Index>(after.size()),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const Index old = order.Triangles[t];
        for (int k = 0; k < 3; ++k)
        {
          // The edge that faces a corner starts at the next one, whichever way round the corners
          // are.
          const Index facing = order.Vertices[after[t][Next(Next(k))]];
          const Index beyond = connectivity.AcrossEdge[old][Next(CornerOf(before[old], facing))];
          renumbered.AcrossEdge[t][k] = beyond == NoIndex ? NoIndex : triangleNow[beyond];
        }
      }
    });
  if (!connectivity.PatchOf.empty())
  {
    renumbered.PatchOf = ByFirst(InOrder(order.Triangles, connectivity.PatchOf));
    renumbered.Common = InOrder(order.Vertices, connectivity.Common);
  }
  return renumbered;
}
}
