// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Gaps.h"

#include "FoldAlong.h"

#include "Core/EdgeGraph.h"
#include "Core/Geometry.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <unordered_set>

namespace arris
{
namespace
{
/// Cosines of the angles to either side of a free end's direction.
struct Cone
{
  double Way; ///< within which the way there must stay
  double Target; ///< within which a feature must be
};
constexpr Cone Near = { 0.5, 0.5 };

/// Farther away a feature must be straight ahead, of a curve that has come over so many edges; the
/// way there may make a detour.
constexpr Cone Far = { 0.0, 0.866 };
constexpr int EdgesBefore = 3;

/// The shortest way from free ends along mesh edges to what is ahead of them.
class Pathfinder
{
public:
  Pathfinder(const Mesh& mesh, const Connectivity& connectivity, double reach, const Cone& cone)
    : Surface(mesh)
    , Adjacency(connectivity)
    , Reach(reach)
    , Cosines(cone)
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
        if (this->IsWithin(this->Cosines.Target, end, direction, stop.Vertex))
        {
          return this->WayBack(stop.Vertex, reached);
        }
        continue; // no way leads through another feature
      }
      for (const Index next : this->Adjacency.NeighborsOfVertex[stop.Vertex])
      {
        const double way =
          stop.Way + (this->Surface.Points[next] - this->Surface.Points[stop.Vertex]).norm();
        const auto known = reached.find(next);
        if (way <= this->Reach && this->IsWithin(this->Cosines.Way, end, direction, next) &&
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
  bool IsWithin(double cosine, Index end, const Vec3& direction, Index vertex) const
  {
    const Vec3 from = this->Surface.Points[vertex] - this->Surface.Points[end];
    return from.dot(direction) >= cosine * from.norm();
  }

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
  const Cone Cosines;
};

/// The direction of a curve at its free end, over some edges if there are so many.
Vec3 DirectionAt(const EdgeGraph& graph, const std::vector<Vec3>& points, Index end, int edges)
{
  Index from = end;
  Index node = graph.Neighbor(end, 0);
  for (int i = 1; i < edges && graph.Valence(node) == 2; ++i)
  {
    const Index next = graph.NeighborBeyond(from, node);
    from = node;
    node = next;
  }
  return DirectionOf(points[graph.MeshVertex(end)] - points[graph.MeshVertex(node)]);
}

/// Lets free ends go on the ways that are found for them and accepted.
template <typename Accept>
void CarryOn(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds,
  const Pathfinder& paths, int edgesBefore, Accept&& accept, std::vector<FeatureEdge>& edges)
{
  const EdgeGraph graph(EndsOf(edges));
  std::unordered_set<Index> network;
  for (Index node = 0; node < graph.size(); ++node)
  {
    network.insert(graph.MeshVertex(node));
  }
  // All ends look for a way before any goes it, so that none is before the others.
  std::set<std::pair<Index, Index>> steps;
  for (Index node = 0; node < graph.size(); ++node)
  {
    const Index end = graph.MeshVertex(node);
    if (graph.Valence(node) != 1 || connectivity.OnBoundary[end])
    {
      continue;
    }
    const Vec3 direction = DirectionAt(graph, mesh.Points, node, edgesBefore);
    const std::vector<Index> way = paths.Find(end, direction, network);
    for (std::size_t i = 0; i + 1 < way.size() && (i > 0 || accept(way)); ++i)
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

void CloseGaps(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds,
  double length, std::vector<FeatureEdge>& edges)
{
  if (length > 0.0)
  {
    const Pathfinder paths(mesh, connectivity, length, Near);
    CarryOn(
      mesh, connectivity, folds, paths, 1, [](const auto&) { return true; }, edges);
  }
}

void CloseFoldedGaps(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds,
  double length, double angle, std::vector<FeatureEdge>& edges)
{
  if (length > 0.0)
  {
    const Pathfinder paths(mesh, connectivity, length, Far);
    const std::vector<FeatureEdge> fences = edges;
    CarryOn(
      mesh, connectivity, folds, paths, EdgesBefore,
      [&](const std::vector<Index>& way)
      { return FoldsAlong(mesh, connectivity, fences, way, angle); },
      edges);
  }
}
}
