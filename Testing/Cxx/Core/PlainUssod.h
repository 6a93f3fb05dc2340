// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PlainUssod.h
/// λτ as Eqs. 1 and 2 of the paper say it, without any haste: what the fast way is held against.

#ifndef arris_testing_PlainUssod_h
#define arris_testing_PlainUssod_h

#include "Core/Geometry.h"

#include <algorithm>
#include <set>
#include <vector>

namespace arris
{
namespace testing
{
/// The triangles that can be reached from a vertex, edge by edge, within a distance of it.
inline std::vector<Index> PlainWindow(const Mesh& mesh, Index vertex, double radius)
{
  const auto shared = [&](Index s, Index t)
  {
    int count = 0;
    for (const Index v : mesh.Triangles[s])
    {
      count += mesh.Triangles[t][CornerOf(mesh.Triangles[t], v)] == v ? 1 : 0;
    }
    return count;
  };
  std::vector<Index> near;
  std::vector<Index> window;
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    const Triangle& triangle = mesh.Triangles[t];
    if (triangle[CornerOf(triangle, vertex)] == vertex)
    {
      window.push_back(t);
    }
    else if (SquaredDistance(mesh.Points[vertex], Corners(mesh, t)) <= radius * radius)
    {
      near.push_back(t);
    }
  }
  std::set<Index> left(near.begin(), near.end());
  for (std::size_t i = 0; i < window.size(); ++i)
  {
    for (const Index t : near)
    {
      if (left.count(t) != 0 && shared(window[i], t) == 2)
      {
        left.erase(t);
        window.push_back(t);
      }
    }
  }
  return window;
}

/// The largest 1 - ni.nj of all pairs in the window.
inline double PlainDifference(
  const Mesh& mesh, const std::vector<Vec3>& unitNormals, Index vertex, double radius)
{
  double largest = 0.0;
  const std::vector<Index> window = PlainWindow(mesh, vertex, radius);
  for (const Index s : window)
  {
    for (const Index t : window)
    {
      if (!unitNormals[s].isZero(0.0) && !unitNormals[t].isZero(0.0))
      {
        largest = std::max(largest, 0.5 * (unitNormals[s] - unitNormals[t]).squaredNorm());
      }
    }
  }
  return std::min(2.0, largest);
}
}
}

#endif
