// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves.h"

#include "Geometry.h"

#include <algorithm>

namespace arris
{
namespace
{
/// The edges as a graph over the vertices they use, numbered anew in ascending order.
class EdgeGraph
{
public:
  explicit EdgeGraph(const std::vector<std::array<Index, 2>>& edges)
  {
    for (const auto& edge : edges)
    {
      this->Vertices.insert(this->Vertices.end(), edge.begin(), edge.end());
    }
    std::sort(this->Vertices.begin(), this->Vertices.end());
    this->Vertices.erase(
      std::unique(this->Vertices.begin(), this->Vertices.end()), this->Vertices.end());

    std::vector<std::array<Index, 3>> ends; // from, to, edge
    ends.reserve(2 * edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      const Index a = this->Number(edges[e][0]);
      const Index b = this->Number(edges[e][1]);
      ends.push_back({ a, b, static_cast<Index>(e) });
      ends.push_back({ b, a, static_cast<Index>(e) });
    }
    std::sort(ends.begin(), ends.end());
    this->Offsets.assign(this->Vertices.size() + 1, 0);
    for (const auto& end : ends)
    {
      ++this->Offsets[end[0] + 1];
      this->To.push_back(end[1]);
      this->Edge.push_back(end[2]);
    }
    for (std::size_t v = 0; v < this->Vertices.size(); ++v)
    {
      this->Offsets[v + 1] += this->Offsets[v];
    }
    this->Used.assign(edges.size(), 0);
  }

  Index size() const { return static_cast<Index>(this->Vertices.size()); }
  Index MeshVertex(Index node) const { return this->Vertices[node]; }
  int Valence(Index node) const { return this->Offsets[node + 1] - this->Offsets[node]; }
  Index Neighbor(Index node, int i) const { return this->To[this->Offsets[node] + i]; }

  /// Walks over one unused edge at the node; NoIndex if there is none.
  Index Step(Index node)
  {
    for (Index i = this->Offsets[node]; i < this->Offsets[node + 1]; ++i)
    {
      if (!this->Used[this->Edge[i]])
      {
        this->Used[this->Edge[i]] = 1;
        return this->To[i];
      }
    }
    return NoIndex;
  }

private:
  Index Number(Index vertex) const
  {
    return static_cast<Index>(
      std::lower_bound(this->Vertices.begin(), this->Vertices.end(), vertex) -
      this->Vertices.begin());
  }

  std::vector<Index> Vertices;
  std::vector<Index> Offsets, To, Edge;
  Flags Used;
};

/// Whether a curve that passes the node turns there by more than the angle of the cosine.
bool Turns(const EdgeGraph& graph, const std::vector<Vec3>& points, Index node, double leastCosine)
{
  const Vec3& at = points[graph.MeshVertex(node)];
  const Vec3 in = at - points[graph.MeshVertex(graph.Neighbor(node, 0))];
  const Vec3 out = points[graph.MeshVertex(graph.Neighbor(node, 1))] - at;
  const double length = in.norm() * out.norm();
  return length > 0.0 && in.dot(out) < leastCosine * length;
}

/// Follows unused edges from the node up to the next corner, or back to the node.
Curve Follow(EdgeGraph& graph, const Flags& isCorner, Index start)
{
  Curve curve;
  for (Index node = graph.Step(start); node != NoIndex; node = graph.Step(node))
  {
    if (curve.empty())
    {
      curve.push_back(graph.MeshVertex(start));
    }
    curve.push_back(graph.MeshVertex(node));
    if (isCorner[node] || node == start)
    {
      break;
    }
  }
  return curve;
}
}

CurveNetwork JoinEdges(const std::vector<std::array<Index, 2>>& edges,
  const std::vector<Vec3>& points, double cornerAngle)
{
  EdgeGraph graph(edges);
  CurveNetwork network;
  Flags isCorner(graph.size());
  const double leastCosine = cornerAngle < 180.0 ? std::cos(cornerAngle * Pi / 180.0) : -2.0;
  for (Index node = 0; node < graph.size(); ++node)
  {
    isCorner[node] = graph.Valence(node) != 2 || Turns(graph, points, node, leastCosine) ? 1 : 0;
    if (isCorner[node])
    {
      network.Corners.push_back({ graph.MeshVertex(node), graph.Valence(node) });
    }
  }
  for (const bool fromCorners : { true, false })
  {
    for (Index node = 0; node < graph.size(); ++node)
    {
      if ((isCorner[node] != 0) != fromCorners)
      {
        continue;
      }
      for (Curve curve = Follow(graph, isCorner, node); !curve.empty();
           curve = Follow(graph, isCorner, node))
      {
        network.Curves.push_back(std::move(curve));
      }
    }
  }
  return network;
}
}
