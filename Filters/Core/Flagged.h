// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Flagged.h
/// Questions about vertices or triangles that bear a flag.

#ifndef arris_Flagged_h
#define arris_Flagged_h

#include "Mesh.h"
#include "Parallel.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The indices whose flag is set, ascending.
ARRISFILTERS_EXPORT std::vector<Index> Flagged(const Flags& flags);

/// Those of the items for which test(item) holds, in their order. Asks in parallel.
template <typename Test>
std::vector<Index> Those(const std::vector<Index>& items, Test&& test)
{
  Flags holds(items.size());
  ParallelFor(static_cast<Index>(items.size()),
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        holds[i] = test(items[i]) ? 1 : 0;
      }
    });
  std::vector<Index> those;
  for (Index i : Flagged(holds))
  {
    those.push_back(items[i]);
  }
  return those;
}

/// For each vertex how many edges it is away from the nearest one with the flag: 0 for these, -1
/// where that is more than `most`.
ARRISFILTERS_EXPORT std::vector<int> EdgesAwayFrom(
  const Connectivity& connectivity, const Flags& flags, int most);

/// Calls visit(group) for each connected group of vertices whose flag is `wanted`. Groups come by
/// their lowest vertex, which is also their first.
template <typename Visit>
void ForEachGroup(
  const Connectivity& connectivity, const Flags& flags, unsigned char wanted, Visit&& visit)
{
  Flags seen(flags.size(), 0);
  std::vector<Index> group;
  for (std::size_t v = 0; v < flags.size(); ++v)
  {
    if (seen[v] || flags[v] != wanted)
    {
      continue;
    }
    group.assign(1, static_cast<Index>(v));
    seen[v] = 1;
    for (std::size_t next = 0; next < group.size(); ++next)
    {
      for (Index n : connectivity.NeighborsOfVertex[group[next]])
      {
        if (!seen[n] && flags[n] == wanted)
        {
          seen[n] = 1;
          group.push_back(n);
        }
      }
    }
    visit(group);
  }
}
}

#endif
