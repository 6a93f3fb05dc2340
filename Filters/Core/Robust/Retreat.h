// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Retreat.h
/// The last guards: take vertices back toward where they were until no triangle is folded over, and
/// none cuts another that did not before.

#ifndef arris_Robust_Retreat_h
#define arris_Robust_Retreat_h

#include "Placement.h"

namespace arris
{
/// Toward `mesh`, which the pass has started from, whatever these triangles and those that change
/// with them ask for. Folded over is what faces against its own face.
void Retreat(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Index>& triangles, Placement& placement);

/// After the last pass toward the `input`, where a triangle is overturned against that (see
/// Overturned.h): one that lies on its neighbour may face as each of their faces does.
void TurnBack(const Mesh& input, const Connectivity& connectivity,
  const std::vector<Index>& triangles, Placement& placement);
}

#endif
