// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Labels.h
/// Which face each damaged vertex belongs to.

#ifndef arris_Robust_Labels_h
#define arris_Robust_Labels_h

#include "Sides.h"

namespace arris
{
/// The patch each vertex belongs to. Labels flood from the intact vertices into the region, least
/// cost first, so that each stays connected with its patch. NoIndex where none arrived.
std::vector<Index> FloodLabels(const Connectivity& connectivity, const Patches& patches,
  const Flags& region, const std::vector<std::vector<Side>>& sides,
  const std::vector<Index>& sidesOf);

/// The side of that patch, or null.
inline const Side* FindSide(const std::vector<Side>& sides, Index patch)
{
  for (const Side& side : sides)
  {
    if (side.Patch == patch)
    {
      return &side;
    }
  }
  return nullptr;
}
}

#endif
