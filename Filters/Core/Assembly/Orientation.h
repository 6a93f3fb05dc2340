// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Orientation.h
/// Winds the triangles of each patch one way round.

#ifndef arris_Assembly_Orientation_h
#define arris_Assembly_Orientation_h

#include "Core/Mesh.h"

namespace arris
{
/// What was done to wind patches one way round.
struct Oriented
{
  Index FlippedTriangles = 0;
  Index OneSidedPatches = 0; ///< those that cannot be, as a Moebius strip
};

/// Turns triangles of `mesh` round until neighbours across the edges that `connectivity` does not
/// cut run along them in opposite directions; one-sided patches are cut (in AcrossEdge) where that
/// cannot be. Where two patches and no third meet, they are wound alike as far as most of their
/// common edges ask for it. Of what hangs together so, the smaller part is turned.
Oriented OrientPatches(Mesh& mesh, const std::vector<Index>& patchOf, Index patchCount,
  const Unfilled<std::array<Index, 3>>& uncut, Connectivity& connectivity);
}

#endif
