// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FarFromRidge.h"

#include "Core/Flagged.h"

namespace arris
{
void LeaveFarFromRidge(const Connectivity& connectivity, const Flags& onRidge,
  const std::vector<Index>& damaged, Placement& placement)
{
  constexpr int Near = 3; // edges; with two, what belongs to acute edges stays as well
  const std::vector<int> away = EdgesAwayFrom(connectivity, onRidge, Near);
  for (Index v : damaged)
  {
    if (away[v] < 0 && !placement.IsSettled(v))
    {
      placement.Leave(v);
    }
  }
}
}
