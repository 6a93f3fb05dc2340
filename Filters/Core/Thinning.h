// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Thinning.h
/// Shrinks the sharp region to its skeleton (section 4.4 and the appendix).

#ifndef arris_Thinning_h
#define arris_Thinning_h

#include "Mesh.h"
#include "Parallel.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// In `ThinningRounds`: the vertex was never in the sharp region.
constexpr int NeverSharp = -1;

/// For each vertex the round, 1 and up, in which thinning removed it from the sharp region, or
/// NeverSharp. The vertices that stay, the skeleton, get the number after the last round: the
/// largest value of all. Empty if the monitor stopped it.
///
/// Thinning is topology alone, so it takes no points. Round by round the vertices on the border of
/// the region are tried; one goes if the sharp vertices around it stay connected without it (the
/// local transitive closure of section 4.4), unless it is on the boundary of the mesh or has at
/// most one sharp neighbour (the tail of a skeleton; the paper says one, and a vertex alone must
/// stay as well, or its region would vanish).
///
/// Where the paper leaves it open: within a round the vertex of the least `priority` is tried
/// first, ties in order of storage; rounds go on until one removes nothing. `priority` may be
/// empty.
ARRISFILTERS_EXPORT std::vector<int> ThinningRounds(const Mesh& mesh,
  const Connectivity& connectivity, const Flags& sharpRegion, const std::vector<double>& priority,
  const Monitor& monitor);
}

#endif
