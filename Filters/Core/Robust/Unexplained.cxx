// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Unexplained.h"

#include "Core/Flagged.h"
#include "Spread.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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
    const bool common = around.Together != nullptr && around.Together->Apart.Common[v];
    unexplained[v] = !common && !IsExplained(around, labelling, v) ? 1 : 0;
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
  const Walk walk = WalkFrom(released, SideFinder::Reach(around), around.TheMesh,
    around.TheConnectivity, around.Scales, [](Index) { return true; });
  std::vector<Index> near;
  std::copy_if(walk.Reached.begin(), walk.Reached.end(), std::back_inserter(near),
    [&](Index v) { return region[v] != 0; });
  return near;
}
}
