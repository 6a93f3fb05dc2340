// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Flagged.h
/// Questions about vertices or triangles that bear a flag.

#ifndef arris_Flagged_h
#define arris_Flagged_h

#include "Mesh.h"

namespace arris
{
/// The indices whose flag is set, ascending.
std::vector<Index> Flagged(const Flags& flags);

/// For each vertex how many edges it is away from the nearest one with the flag: 0 for these, -1
/// where that is more than `most`.
std::vector<int> EdgesAwayFrom(const Connectivity& connectivity, const Flags& flags, int most);

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
