// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Spread.h
/// Walks over the mesh's edges away from some vertices: how the reach of an edge is told.

#ifndef arris_Robust_Spread_h
#define arris_Robust_Spread_h

#include "Core/Mesh.h"

#include <queue>

namespace arris
{
/// Takes the seeds (flagged) and what is reached from them, nearest first by the straight way from
/// the seed: calls take(vertex, seed) once for each vertex, which is reached only if
/// mayReach(vertex, distance, seed).
template <typename MayReach, typename Take>
void SpreadFrom(const Flags& seeds, const std::vector<Vec3>& points,
  const Connectivity& connectivity, MayReach&& mayReach, Take&& take)
{
  struct Reached
  {
    double Distance;
    Index Vertex;
    Index Seed;
    bool operator<(const Reached& other) const // nearest first
    {
      return this->Distance != other.Distance ? this->Distance > other.Distance
                                              : this->Vertex > other.Vertex;
    }
  };
  std::priority_queue<Reached> front;
  for (std::size_t v = 0; v < seeds.size(); ++v)
  {
    if (seeds[v])
    {
      front.push({ 0.0, static_cast<Index>(v), static_cast<Index>(v) });
    }
  }
  Flags done(seeds.size(), 0);
  while (!front.empty())
  {
    const Reached at = front.top();
    front.pop();
    if (done[at.Vertex])
    {
      continue;
    }
    done[at.Vertex] = 1;
    take(at.Vertex, at.Seed);
    for (Index n : connectivity.NeighborsOfVertex[at.Vertex])
    {
      const double distance = (points[n] - points[at.Seed]).norm();
      if (!done[n] && mayReach(n, distance, at.Seed))
      {
        front.push({ distance, n, at.Seed });
      }
    }
  }
}

/// What a walk over edges has reached, the sources first, and of each vertex the source (any near
/// one) that it was reached from; NoIndex if none.
struct Walk
{
  std::vector<Index> Reached;
  std::vector<Index> OriginOf;
};

/// Walks up to `reach` (in local scales) from the sources, where mayEnter(vertex).
template <typename MayEnter>
Walk WalkFrom(const std::vector<Index>& sources, double reach, const Mesh& mesh,
  const Connectivity& connectivity, const std::vector<double>& scales, MayEnter&& mayEnter)
{
  Walk walk{ sources, std::vector<Index>(mesh.Points.size(), NoIndex) };
  for (Index v : sources)
  {
    walk.OriginOf[v] = v;
  }
  for (std::size_t next = 0; next < walk.Reached.size(); ++next)
  {
    const Index origin = walk.OriginOf[walk.Reached[next]];
    for (Index n : connectivity.NeighborsOfVertex[walk.Reached[next]])
    {
      if (walk.OriginOf[n] == NoIndex && mayEnter(n) &&
        (mesh.Points[n] - mesh.Points[origin]).norm() <= reach * scales[n])
      {
        walk.OriginOf[n] = origin;
        walk.Reached.push_back(n);
      }
    }
  }
  return walk;
}
}

#endif
