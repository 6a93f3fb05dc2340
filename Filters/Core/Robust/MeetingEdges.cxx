// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeetingEdges.h"

#include "Core/Flagged.h"
#include "Core/Parallel.h"

#include <algorithm>

namespace arris
{
namespace
{
constexpr int Passes = 2; // the second beside what the first has uncovered
constexpr int MostEdges = 5; // as far as the sides of a turn reach

/// The vertices outside the region but no more than `MostEdges` away from what is new in it.
std::vector<Index> VerticesBeside(
  const Connectivity& connectivity, const Flags& fresh, const Flags& region)
{
  const std::vector<int> away = EdgesAwayFrom(connectivity, fresh, MostEdges);
  std::vector<Index> beside;
  for (std::size_t v = 0; v < away.size(); ++v)
  {
    if (away[v] > 0 && !region[v])
    {
      beside.push_back(static_cast<Index>(v));
    }
  }
  return beside;
}

/// Takes out what is connected with nothing that was in the region before: no edge ends there.
void DropStray(const Connectivity& connectivity, const Flags& before, Flags& region)
{
  std::vector<Index> stray;
  ForEachGroup(connectivity, region, 1,
    [&](const std::vector<Index>& group)
    {
      if (std::none_of(group.begin(), group.end(), [&](Index v) { return before[v] != 0; }))
      {
        stray.insert(stray.end(), group.begin(), group.end());
      }
    });
  for (Index v : stray)
  {
    region[v] = 0;
  }
}
}

void ExtendToOtherEdges(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& scales, const std::vector<Turn>& turns, const EdgeAngles& angles,
  bool rounded, Flags& region)
{
  const Flags before = region;
  Flags fresh = region;
  for (int pass = 0; pass < Passes; ++pass)
  {
    const std::vector<Index> beside = VerticesBeside(connectivity, fresh, region);
    Flags found(beside.size(), 0);
    ParallelFor(static_cast<Index>(beside.size()),
      [&](Index begin, Index end)
      {
        TurnMeter meter(mesh, connectivity, faces, scales);
        meter.LookWithin(region, rounded);
        for (Index i = begin; i < end; ++i)
        {
          found[i] =
            !IsFlat(turns[beside[i]]) && ShowsEdge(meter.Measure(beside[i]), angles) ? 1 : 0;
        }
      });
    std::fill(fresh.begin(), fresh.end(), 0);
    for (std::size_t i = 0; i < beside.size(); ++i)
    {
      region[beside[i]] = fresh[beside[i]] = found[i];
    }
  }
  DropStray(connectivity, before, region);
}
}
