// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FarFromRidge.h
/// Damaged vertices that no edge is near to.

#ifndef arris_Robust_FarFromRidge_h
#define arris_Robust_FarFromRidge_h

#include "Placement.h"

namespace arris
{
/// Leaves those of the damaged vertices where they are that are more than three edges away from
/// what is on the ridge: sampling has not moved them, and where an edge fades the one face that is
/// left of its two may lie elsewhere.
ARRISFILTERS_EXPORT void LeaveFarFromRidge(const Connectivity& connectivity, const Flags& onRidge,
  const std::vector<Index>& damaged, Placement& placement);
}

#endif
