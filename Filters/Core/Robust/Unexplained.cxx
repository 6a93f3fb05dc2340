// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Unexplained.h"

#include "Core/Flagged.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
/// Farther than this from all sides (in local scales) no sampling puts a vertex of an edge.
constexpr double FarFromSides = 0.35;

/// How much farther rounding puts it.
constexpr double FarBlended = 0.6;

/// Fewer vertices than this are no face.
constexpr std::size_t SmallestFace = 3;

bool IsExplained(const Surroundings& around, const Labelling& labelling, Index vertex)
{
  const std::vector<Side>& sides = labelling.Sides[labelling.SidesOf[vertex]];
  const double reach = (FarFromSides + FarBlended * around.Rounding) * around.Scales[vertex];
  return std::any_of(sides.begin(), sides.end(),
    [&](const Side& side)
    { return std::abs(side.Surface.Distance(around.TheMesh.Points[vertex])) <= reach; });
}
}

std::vector<Index> ReleaseUnexplained(const Surroundings& around, const std::vector<Index>& damaged,
  const Labelling& labelling, Flags& region)
{
  Flags unexplained(region.size(), 0);
  for (Index v : damaged)
  {
    // Where patches of an assembly meet, sampling takes vertices off by more, and they are no face.
    const bool isFace = !around.TheConnectivity.OnBoundary[v] && !IsExplained(around, labelling, v);
    unexplained[v] = isFace ? 1 : 0;
  }
  std::vector<Index> released;
  ForEachGroup(around.TheConnectivity, unexplained, 1,
    [&](const std::vector<Index>& group)
    {
      if (group.size() >= SmallestFace)
      {
        released.insert(released.end(), group.begin(), group.end());
      }
    });
  std::sort(released.begin(), released.end());
  for (Index v : released)
  {
    region[v] = 0;
  }
  return released;
}

std::vector<Index> DamagedNear(
  const Surroundings& around, const std::vector<Index>& released, const Flags& region)
{
  // Each vertex reached remembers where from; the nearest origin is not needed, any will do.
  std::vector<Index> origin(region.size(), NoIndex);
  std::vector<Index> front = released;
  for (Index v : released)
  {
    origin[v] = v;
  }
  const double reach = SideFinder::Reach(around.Roughness);
  std::vector<Index> near;
  for (std::size_t next = 0; next < front.size(); ++next)
  {
    const Index v = front[next];
    for (Index n : around.TheConnectivity.NeighborsOfVertex[v])
    {
      const Vec3 way = around.TheMesh.Points[n] - around.TheMesh.Points[origin[v]];
      if (origin[n] == NoIndex && way.norm() <= reach * around.Scales[n])
      {
        origin[n] = origin[v];
        front.push_back(n);
        if (region[n])
        {
          near.push_back(n);
        }
      }
    }
  }
  return near;
}
}
