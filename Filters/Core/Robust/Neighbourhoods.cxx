// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Neighbourhoods.h"

#include "Sides.h"

#include <algorithm>

namespace arris
{
namespace
{
/// How far from its centre a neighbourhood reaches, in local scales.
constexpr double NeighbourhoodRadius = 1.5;
}

Rows GroupIntoNeighbourhoods(const Surroundings& around, const std::vector<Index>& damaged)
{
  const std::vector<double>& sharpness = around.Flatness; // λτ: the larger the less flat
  std::vector<Index> centers = damaged;
  std::sort(centers.begin(), centers.end(),
    [&](Index a, Index b)
    { return sharpness[a] != sharpness[b] ? sharpness[a] > sharpness[b] : a < b; });
  Flags open(sharpness.size(), 0);
  for (Index v : damaged)
  {
    open[v] = 1;
  }
  const std::vector<Vec3>& points = around.TheMesh.Points;
  Rows groups;
  groups.Offsets.push_back(0);
  groups.Values.reserve(damaged.size());
  for (Index center : centers)
  {
    if (!open[center])
    {
      continue;
    }
    const double radius = NeighbourhoodRadius * around.Scales[center];
    std::size_t next = groups.Values.size();
    groups.Values.push_back(center);
    open[center] = 0;
    for (; next < groups.Values.size(); ++next)
    {
      for (Index n : around.TheConnectivity.NeighborsOfVertex[groups.Values[next]])
      {
        if (open[n] && (points[n] - points[center]).squaredNorm() <= radius * radius)
        {
          open[n] = 0;
          groups.Values.push_back(n);
        }
      }
    }
    groups.Offsets.push_back(static_cast<Index>(groups.Values.size()));
  }
  return groups;
}
}
