// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file EdgeFlips.h
/// Where the connectivity leaves triangles no room on their face, another edge between the same two
/// may.

#ifndef arris_Robust_EdgeFlips_h
#define arris_Robust_EdgeFlips_h

#include "Placement.h"

namespace arris
{
/// Flips edges of the sharp region, between triangles of one face, wherever the worse of the two
/// has little area or is folded over and gets better so. A flip is taken only if it would be good
/// at the unmoved positions too: whatever is given back afterwards leaves nothing folded. The
/// triangles keep their numbers, the vertices their sheets. Not for assemblies, whose patches would
/// be joined. Returns how many were flipped.
ARRISFILTERS_EXPORT Index FlipEdges(Mesh& mesh, Connectivity& connectivity, Placement& placement);
}

#endif
