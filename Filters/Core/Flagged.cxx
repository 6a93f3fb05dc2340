// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Flagged.h"

namespace arris
{
std::vector<Index> Flagged(const Flags& flags)
{
  std::vector<Index> flagged;
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    if (flags[i])
    {
      flagged.push_back(static_cast<Index>(i));
    }
  }
  return flagged;
}

std::vector<int> EdgesAwayFrom(const Connectivity& connectivity, const Flags& flags, int most)
{
  std::vector<int> away(flags.size(), -1);
  std::vector<Index> front = Flagged(flags);
  for (Index v : front)
  {
    away[v] = 0;
  }
  for (std::size_t next = 0; next < front.size() && away[front[next]] < most; ++next)
  {
    for (Index n : connectivity.NeighborsOfVertex[front[next]])
    {
      if (away[n] < 0)
      {
        away[n] = away[front[next]] + 1;
        front.push_back(n);
      }
    }
  }
  return away;
}
}
