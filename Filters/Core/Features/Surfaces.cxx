// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Surfaces.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace arris
{
namespace
{
/// All triangles at an edge.
void TrianglesAt(const Mesh& mesh, const Connectivity& connectivity, const FeatureEdge& edge,
  std::vector<Index>& ring)
{
  const Index t = edge.Left != NoIndex ? edge.Left : edge.Right;
  RingOfEdge(mesh, connectivity, t, EdgeBetween(mesh.Triangles[t], edge.A, edge.B), ring);
}

/// For each triangle the edges that cannot be crossed, one bit each.
std::vector<unsigned char> Fences(
  const Mesh& mesh, const Connectivity& connectivity, const std::vector<FeatureEdge>& features)
{
  std::vector<unsigned char> fences(mesh.Triangles.size(), 0);
  std::vector<Index> ring;
  for (const FeatureEdge& edge : features)
  {
    TrianglesAt(mesh, connectivity, edge, ring);
    for (const Index around : ring)
    {
      fences[around] |=
        static_cast<unsigned char>(1 << EdgeBetween(mesh.Triangles[around], edge.A, edge.B));
    }
  }
  return fences;
}

/// Gives the number `id` to everything connected with `seed`.
void FloodFrom(Index seed, Index id, const Connectivity& connectivity,
  const std::vector<unsigned char>& fences, std::vector<Index>& front, std::vector<Index>& ids)
{
  front.assign(1, seed);
  ids[seed] = id;
  while (!front.empty())
  {
    const Index t = front.back();
    front.pop_back();
    for (int k = 0; k < 3; ++k)
    {
      const Index next = connectivity.AcrossEdge[t][k];
      if (next != NoIndex && ids[next] == NoIndex && !(fences[t] & (1 << k)))
      {
        ids[next] = id;
        front.push_back(next);
      }
    }
  }
}

/// Areas summed in the order of storage, which no thread can change.
std::vector<SurfaceMeasures> Measure(
  const Mesh& mesh, const std::vector<Index>& ids, std::size_t count)
{
  std::vector<double> areas(ids.size());
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        areas[t] = 0.5 * Corners(mesh, t).AreaVector().norm();
      }
    });
  std::vector<SurfaceMeasures> measures(count);
  for (std::size_t t = 0; t < ids.size(); ++t)
  {
    measures[ids[t]].Area += areas[t];
    ++measures[ids[t]].Triangles;
  }
  return measures;
}

/// Numbers the surfaces anew, the largest first.
void SortByArea(Surfaces& surfaces)
{
  std::vector<Index> byArea(surfaces.Measures.size());
  std::iota(byArea.begin(), byArea.end(), 0);
  std::stable_sort(byArea.begin(), byArea.end(),
    [&](Index a, Index b) { return surfaces.Measures[a].Area > surfaces.Measures[b].Area; });
  std::vector<Index> rank(byArea.size());
  std::vector<SurfaceMeasures> sorted;
  for (std::size_t i = 0; i < byArea.size(); ++i)
  {
    rank[byArea[i]] = static_cast<Index>(i);
    sorted.push_back(surfaces.Measures[byArea[i]]);
  }
  for (Index& id : surfaces.Ids)
  {
    id = rank[id];
  }
  surfaces.Measures = std::move(sorted);
}

/// Counts the connected pieces of each surface's border, joining ends of its edges.
class LoopCounter
{
public:
  void Add(Index surface, Index a, Index b)
  {
    const Key rootA = this->Root(surface, a);
    const Key rootB = this->Root(surface, b);
    this->Parent[std::max(rootA, rootB)] = std::min(rootA, rootB);
  }
  void CountInto(std::vector<SurfaceMeasures>& measures) const
  {
    for (const auto& [key, parent] : this->Parent)
    {
      measures[key.first].BoundaryLoops += key == parent ? 1 : 0;
    }
  }

private:
  using Key = std::pair<Index, Index>; // surface, vertex

  Key Root(Index surface, Index vertex)
  {
    Key key{ surface, vertex };
    this->Parent.insert({ key, key });
    while (this->Parent[key] != key)
    {
      Key& parent = this->Parent[key];
      parent = this->Parent[parent]; // halves the way for whoever comes next
      key = parent;
    }
    return key;
  }

  std::map<Key, Key> Parent;
};

/// The border runs along features between two surfaces, and wherever the mesh ends.
void CountLoops(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& features, Surfaces& surfaces)
{
  LoopCounter loops;
  std::vector<Index> ring;
  for (const FeatureEdge& edge : features)
  {
    TrianglesAt(mesh, connectivity, edge, ring);
    const bool divides = std::any_of(ring.begin(), ring.end(),
      [&](Index other) { return surfaces.Ids[other] != surfaces.Ids[ring.front()]; });
    for (const Index around : divides ? ring : std::vector<Index>())
    {
      loops.Add(surfaces.Ids[around], edge.A, edge.B);
    }
  }
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (connectivity.AcrossEdge[t][k] == NoIndex)
      {
        const Triangle& triangle = mesh.Triangles[t];
        loops.Add(surfaces.Ids[t], triangle[k], triangle[Next(k)]);
      }
    }
  }
  loops.CountInto(surfaces.Measures);
}
}

Surfaces FindSurfaces(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& sortedFeatures)
{
  const std::vector<unsigned char> fences = Fences(mesh, connectivity, sortedFeatures);
  Surfaces surfaces;
  surfaces.Ids.assign(mesh.Triangles.size(), NoIndex);
  std::vector<Index> front;
  Index count = 0;
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    if (surfaces.Ids[t] == NoIndex)
    {
      FloodFrom(t, count++, connectivity, fences, front, surfaces.Ids);
    }
  }
  surfaces.Measures = Measure(mesh, surfaces.Ids, static_cast<std::size_t>(count));
  SortByArea(surfaces);
  CountLoops(mesh, connectivity, sortedFeatures, surfaces);
  return surfaces;
}
}
