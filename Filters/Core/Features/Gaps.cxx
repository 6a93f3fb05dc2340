// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Gaps.h"

#include "Core/EdgeGraph.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <unordered_set>

namespace arris
{
namespace
{
/// The cosine of the angle to either side within which something is ahead of a free end.
constexpr double Ahead = 0.5;

/// The shortest way from free ends along mesh edges to what is ahead of them.
class Pathfinder
{
public:
  Pathfinder(const Mesh& mesh, const Connectivity& connectivity, double reach)
    : Surface(mesh)
    , Adjacency(connectivity)
    , Reach(reach)
  {
  }

  /// The vertices from `end` up to one of the network's, both included; empty if there is none.
  std::vector<Index> Find(
    Index end, const Vec3& direction, const std::unordered_set<Index>& network) const
  {
    struct Stop
    {
      double Way;
      Index Vertex;
      bool operator>(const Stop& other) const
      {
        return this->Way != other.Way ? this->Way > other.Way : this->Vertex > other.Vertex;
      }
    };
    std::map<Index, std::pair<double, Index>> reached{ { end, { 0.0, NoIndex } } }; // way, from
    std::priority_queue<Stop, std::vector<Stop>, std::greater<>> front;
    front.push({ 0.0, end });
    while (!front.empty())
    {
      const Stop stop = front.top();
      front.pop();
      if (stop.Way > reached[stop.Vertex].first)
      {
        continue; // a longer way to where another one led meanwhile
      }
      if (stop.Vertex != end && network.count(stop.Vertex) > 0)
      {
        return this->WayBack(stop.Vertex, reached);
      }
      for (const Index next : this->Adjacency.NeighborsOfVertex[stop.Vertex])
      {
        const Vec3 from = this->Surface.Points[next] - this->Surface.Points[end];
        const double way =
          stop.Way + (this->Surface.Points[next] - this->Surface.Points[stop.Vertex]).norm();
        const auto known = reached.find(next);
        if (way <= this->Reach && from.dot(direction) >= Ahead * from.norm() &&
          (known == reached.end() || way < known->second.first))
        {
          reached[next] = { way, stop.Vertex };
          front.push({ way, next });
        }
      }
    }
    return {};
  }

private:
  static std::vector<Index> WayBack(
    Index from, const std::map<Index, std::pair<double, Index>>& reached)
  {
    std::vector<Index> way;
    for (Index v = from; v != NoIndex; v = reached.at(v).second)
    {
      way.push_back(v);
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  const Mesh& Surface;
  const Connectivity& Adjacency;
  const double Reach;
};
}

void CloseGaps(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds,
  double length, std::vector<FeatureEdge>& edges)
{
  if (length <= 0.0)
  {
    return;
  }
  const EdgeGraph graph(EndsOf(edges));
  std::unordered_set<Index> network;
  for (Index node = 0; node < graph.size(); ++node)
  {
    network.insert(graph.MeshVertex(node));
  }
  // All ends look for a way before any goes it, so that none is before the others.
  const Pathfinder paths(mesh, connectivity, length);
  std::set<std::pair<Index, Index>> steps;
  for (Index node = 0; node < graph.size(); ++node)
  {
    const Index end = graph.MeshVertex(node);
    if (graph.Valence(node) != 1 || connectivity.OnBoundary[end])
    {
      continue;
    }
    const Vec3 direction =
      (mesh.Points[end] - mesh.Points[graph.MeshVertex(graph.Neighbor(node, 0))]).normalized();
    const std::vector<Index> way = paths.Find(end, direction, network);
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
    {
      steps.insert(std::minmax(way[i], way[i + 1]));
    }
  }
  for (const auto& [a, b] : steps)
  {
    edges.push_back(MakeFeatureBetween(mesh, connectivity, folds, a, b));
  }
  SortEdges(edges);
}
}
