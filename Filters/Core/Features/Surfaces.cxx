// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Surfaces.h"

#include "Core/SortUnique.h"

#include <algorithm>
#include <atomic>
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

/// Disjoint sets of triangles that threads may join at once. A root is the lowest of its set, so
/// that the outcome does not depend on who came first.
class TriangleSets
{
public:
  explicit TriangleSets(Index count)
    : Parents(static_cast<std::size_t>(count))
  {
    ParallelFor(count,
      [&](Index begin, Index end)
      {
        for (Index t = begin; t < end; ++t)
        {
          this->Parents[t].store(t, std::memory_order_relaxed);
        }
      });
  }

  Index Root(Index t)
  {
    Index parent = this->Parents[t].load(std::memory_order_relaxed);
    while (parent != t)
    {
      const Index beyond = this->Parents[parent].load(std::memory_order_relaxed);
      if (beyond == parent)
      {
        return parent;
      }
      // Halves the way for whoever comes next; if another thread did, that is as well.
      this->Parents[t].compare_exchange_weak(parent, beyond, std::memory_order_relaxed);
      t = beyond;
      parent = this->Parents[t].load(std::memory_order_relaxed);
    }
    return t;
  }

  void Join(Index a, Index b)
  {
    while (true)
    {
      a = this->Root(a);
      b = this->Root(b);
      if (a == b)
      {
        return;
      }
      Index high = std::max(a, b);
      // Fails if another thread has joined the higher root to something meanwhile.
      if (this->Parents[high].compare_exchange_strong(
            high, std::min(a, b), std::memory_order_relaxed))
      {
        return;
      }
    }
  }

private:
  std::vector<std::atomic<Index>> Parents; // never higher than their child
};

/// For each triangle the number of its surface, in the order of their lowest triangles; how many
/// there are.
Index NumberSurfaces(const Connectivity& connectivity, const std::vector<unsigned char>& fences,
  std::vector<Index>& ids)
{
  const auto triangles = static_cast<Index>(fences.size());
  TriangleSets sets(triangles);
  ParallelFor(triangles,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Index next = connectivity.AcrossEdge[t][k];
          if (next > t && !(fences[t] & (1 << k)))
          {
            sets.Join(t, next);
          }
        }
      }
    });
  Index count = 0;
  ids.resize(fences.size());
  for (Index t = 0; t < triangles; ++t)
  {
    const Index root = sets.Root(t);
    ids[t] = root == t ? count++ : ids[root];
  }
  return count;
}

/// Areas summed in the order of storage, which no thread can change: they are found on all threads,
/// a block at a time.
std::vector<SurfaceMeasures> Measure(
  const Mesh& mesh, const std::vector<Index>& ids, std::size_t count)
{
  constexpr Index Block = 65536;
  std::vector<double> areas(Block);
  std::vector<SurfaceMeasures> measures(count);
  for (Index first = 0; first < mesh.TriangleCount(); first += Block)
  {
    const Index size = std::min(Block, mesh.TriangleCount() - first);
    ParallelFor(size,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          areas[i] = 0.5 * Corners(mesh, first + i).AreaVector().norm();
        }
      });
    // Triangles of one surface mostly come one after the other: its sum need not go to memory.
    for (Index i = 0; i < size;)
    {
      const Index id = ids[first + i];
      const Index start = i;
      SurfaceMeasures& own = measures[id];
      own.First = own.Triangles == 0 ? first + i : own.First;
      double area = own.Area;
      for (; i < size && ids[first + i] == id; ++i)
      {
        area += areas[i];
      }
      own.Area = area;
      own.Triangles += i - start;
    }
  }
  return measures;
}

void Renumber(const std::vector<Index>& numbers, std::vector<Index>& ids)
{
  ParallelFor(static_cast<Index>(ids.size()),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        ids[t] = numbers[ids[t]];
      }
    });
}

/// Measures the surfaces and numbers them anew, the largest first.
void SortByArea(const Mesh& mesh, std::size_t count, Surfaces& surfaces)
{
  std::vector<SurfaceMeasures> measures = Measure(mesh, surfaces.Ids, count);
  std::vector<Index> byArea(count);
  std::iota(byArea.begin(), byArea.end(), 0);
  std::sort(byArea.begin(), byArea.end(),
    [&](Index a, Index b)
    {
      return measures[a].Area != measures[b].Area ? measures[a].Area > measures[b].Area
                                                  : measures[a].First < measures[b].First;
    });
  std::vector<Index> rank(count);
  surfaces.Measures.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    rank[byArea[i]] = static_cast<Index>(i);
    surfaces.Measures.push_back(measures[byArea[i]]);
  }
  Renumber(rank, surfaces.Ids);
}

/// What one of some joined things goes back to; a root is its own parent.
template <typename Number>
Number RootOf(Number at, std::vector<Number>& parents)
{
  while (parents[at] != at)
  {
    at = parents[at] = parents[parents[at]]; // halves the way for whoever comes next
  }
  return at;
}

/// Counts the connected pieces of each surface's border, joining ends of its edges.
class LoopCounter
{
public:
  void Add(Index surface, Index a, Index b)
  {
    this->Ends.emplace_back(surface, a); // of one edge after the other
    this->Ends.emplace_back(surface, b);
  }

  void CountInto(std::vector<SurfaceMeasures>& measures)
  {
    std::vector<End> ends = this->Ends;
    SortUnique(ends);
    std::vector<std::size_t> parents(ends.size());
    std::iota(parents.begin(), parents.end(), 0);
    const auto root = [&](const End& end)
    {
      return RootOf<std::size_t>(
        std::lower_bound(ends.begin(), ends.end(), end) - ends.begin(), parents);
    };
    for (std::size_t i = 0; i < this->Ends.size(); i += 2)
    {
      const auto [low, high] = std::minmax({ root(this->Ends[i]), root(this->Ends[i + 1]) });
      parents[high] = low;
    }
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      measures[ends[i].first].BoundaryLoops += parents[i] == i ? 1 : 0;
    }
  }

private:
  using End = std::pair<Index, Index>; // surface, vertex

  std::vector<End> Ends;
};
}

Surfaces FindSurfaces(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& sortedFeatures)
{
  const std::vector<unsigned char> fences = Fences(mesh, connectivity, sortedFeatures);
  Surfaces surfaces;
  const Index count = NumberSurfaces(connectivity, fences, surfaces.Ids);
  SortByArea(mesh, static_cast<std::size_t>(count), surfaces);
  return surfaces;
}

void JoinSurfaces(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& dropped, Surfaces& surfaces)
{
  std::vector<Index> joined(surfaces.Measures.size()); // with which one, or itself
  std::iota(joined.begin(), joined.end(), 0);
  bool any = false;
  std::vector<Index> ring;
  for (const FeatureEdge& edge : dropped)
  {
    TrianglesAt(mesh, connectivity, edge, ring);
    for (const Index around : ring)
    {
      const Index a = RootOf(surfaces.Ids[ring.front()], joined);
      const Index b = RootOf(surfaces.Ids[around], joined);
      joined[std::max(a, b)] = std::min(a, b);
      any = any || a != b;
    }
  }
  if (!any)
  {
    return;
  }
  Index count = 0;
  std::vector<Index> numbers(joined.size());
  for (Index id = 0; id < static_cast<Index>(joined.size()); ++id)
  {
    numbers[id] = joined[id] == id ? count++ : numbers[RootOf(id, joined)];
  }
  Renumber(numbers, surfaces.Ids);
  SortByArea(mesh, static_cast<std::size_t>(count), surfaces);
}

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
  const bool open = HasBoundary(connectivity);
  for (Index t = 0; open && t < mesh.TriangleCount(); ++t)
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
