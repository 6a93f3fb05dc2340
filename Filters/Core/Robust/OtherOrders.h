// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file OtherOrders.h
/// Mends again what was tangled, in other orders, and takes the outcome with the fewest creases.

#ifndef arris_Robust_OtherOrders_h
#define arris_Robust_OtherOrders_h

#include "Labelled.h"
#include "Placement.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Which triangle is mended first decides what room there is for those beside it, and which faces
/// they end up on; nothing tells beforehand which order is right. Afterwards the creases do (see
/// Creases.h), where no more triangles are turned over: spot by spot, as far as outcomes differ.
///
/// `placed` is the placement before anything was mended, `tangled` what mending has moved since,
/// and `placement` what came of it once nothing was folded or cut; `wanted` is where vertices were
/// before they had to retreat for that. Both are brought up to date.
ARRISFILTERS_EXPORT void TryOtherOrders(const Labelled& mesh, const Placement& placed,
  const std::vector<Index>& tangled, Placement& placement, std::vector<Vec3>& wanted);
}

#endif
