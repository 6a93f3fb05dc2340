// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Straighten.h
/// Tries each damaged vertex on the other faces near it, on their ridges and in their corners, and
/// where it came from, and takes what leaves the mesh least creased.

#ifndef arris_Robust_Straighten_h
#define arris_Robust_Straighten_h

#include "Placement.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Of these damaged vertices, and those that change with them. `input` are the positions that the
/// vertices came with.
ARRISFILTERS_EXPORT void Straighten(const Mesh& mesh, const Connectivity& connectivity,
  const Labelling& labelling, const std::vector<Vec3>& input, const std::vector<Index>& damaged,
  Placement& placement);
}

#endif
