// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Surfaces.h"

#include "Geometry.h"

#include <algorithm>
#include <numeric>

namespace arris
{
namespace
{
/// Gives the number `id` to everything connected with `seed`; the area of it.
double FloodFrom(Index seed, Index id, const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& sortedFeatures, std::vector<Index>& ids)
{
  double area = 0.0;
  std::vector<Index> front(1, seed);
  ids[seed] = id;
  while (!front.empty())
  {
    const Index t = front.back();
    front.pop_back();
    area += 0.5 * Corners(mesh, t).AreaVector().norm();
    for (int k = 0; k < 3; ++k)
    {
      const Index next = connectivity.AcrossEdge[t][k];
      const Triangle& triangle = mesh.Triangles[t];
      if (next != NoIndex && ids[next] == NoIndex &&
        FindFeature(sortedFeatures, triangle[k], triangle[Next(k)]) == nullptr)
      {
        ids[next] = id;
        front.push_back(next);
      }
    }
  }
  return area;
}
}

std::vector<Index> SurfaceIds(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& sortedFeatures)
{
  std::vector<Index> ids(mesh.Triangles.size(), NoIndex);
  std::vector<double> areas;
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    if (ids[t] == NoIndex)
    {
      areas.push_back(
        FloodFrom(t, static_cast<Index>(areas.size()), mesh, connectivity, sortedFeatures, ids));
    }
  }
  std::vector<Index> byArea(areas.size());
  std::iota(byArea.begin(), byArea.end(), 0);
  std::stable_sort(
    byArea.begin(), byArea.end(), [&](Index a, Index b) { return areas[a] > areas[b]; });
  std::vector<Index> rank(areas.size());
  for (std::size_t i = 0; i < byArea.size(); ++i)
  {
    rank[byArea[i]] = static_cast<Index>(i);
  }
  for (Index& id : ids)
  {
    id = rank[id];
  }
  return ids;
}
}
