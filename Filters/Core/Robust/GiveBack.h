// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file GiveBack.h
/// Gives back what a recovery has made worse.

#ifndef arris_Robust_GiveBack_h
#define arris_Robust_GiveBack_h

#include "Placement.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Puts each connected part of the region back to `input`, the positions that the vertices came
/// with, unless its recovery has left fewer creases than there were. What sampling has damaged gets
/// fewer (on contours of solids a half of them, on blurred ones and segmentations up to nine
/// tenths); a part of a mesh that no sampling has made, such as a scan's fine folds or the
/// tessellation of a thread, gets more where it is taken for damage. Parts with a tip
/// stay as they are. Returns the vertices of what was given back.
ARRISFILTERS_EXPORT std::vector<Index> GiveBackTheMoreCreased(const Mesh& mesh,
  const Connectivity& connectivity, const Flags& region, const std::vector<Vec3>& input,
  Placement& placement);
}

#endif
