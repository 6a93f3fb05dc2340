// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Unexplained.h"

#include "Core/Flagged.h"
#include "Spread.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace arris
{
namespace
{
/// Farther than this from all sides (in local scales) no sampling puts a vertex of an edge.
constexpr double FarFromSides = 0.35;

/// How much farther rounding puts it, at a corner of three faces.
constexpr double FarRounded = 1.0;

/// On a narrow face that is rounded on either side, what is less far off than that is bent too much
/// to speak for the face, but connects what does.
constexpr double FarConnecting = 0.3;

/// Fewer vertices than this are no face.
constexpr std::size_t SmallestFace = 3;

/// How far a vertex is from the nearest of its sides, in local scales; infinite if it has none.
double DistanceToSides(const Surroundings& around, const Labelling& labelling, Index vertex)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Side& side : labelling.Sides[labelling.SidesOf[vertex]])
  {
    least = std::min(least, std::abs(side.Surface.Distance(around.TheMesh.Points[vertex])));
  }
  return least / around.Scales[vertex];
}
}

std::vector<Index> ReleaseUnexplained(const Surroundings& around, const std::vector<Index>& damaged,
  const Labelling& labelling, Flags& region)
{
  Flags isOff(region.size(), 0), isConnecting(region.size(), 0);
  for (Index v : damaged)
  {
    // Where patches of an assembly meet, sampling takes vertices off by more, and they are no face.
    const bool common = around.Together != nullptr && around.Together->Apart.Common[v];
    const double off = common ? 0.0 : DistanceToSides(around, labelling, v);
    isOff[v] = off > FarFromSides + FarRounded * around.Rounding ? 1 : 0;
    isConnecting[v] = off > FarFromSides + FarConnecting * around.Rounding ? 1 : 0;
  }
  std::vector<Index> released;
  ForEachGroup(around.TheConnectivity, isConnecting, 1,
    [&](const std::vector<Index>& group)
    {
      const std::vector<Index> face = Those(group, [&](Index v) { return isOff[v] != 0; });
      if (face.size() >= SmallestFace)
      {
        released.insert(released.end(), face.begin(), face.end());
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
