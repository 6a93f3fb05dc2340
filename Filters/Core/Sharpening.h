// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Sharpening.h
/// Moves the vertices of the sharp region to where their predictors say: from outside inwards in
/// the order of thinning, then the skeleton (sections 3.3 and 4.5).

#ifndef arris_Sharpening_h
#define arris_Sharpening_h

#include "Mesh.h"
#include "Parallel.h"
#include "Skeleton.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// New positions for all vertices; those never in the sharp region keep theirs to the last bit.
/// Empty if the monitor stopped it. Who needs the mesh no more moves it in: its points are moved in
/// place.
///
/// `windowRadius` is λ; `averageEdgeLength` bounds the translation by 4 L (section 4.3).
/// All vertices of one thinning round are predicted from what earlier rounds left, and then moved
/// together, as are all branch vertices and all joint vertices: so neither the order of storage
/// nor the number of threads matters. (The paper moves them one by one.)
ARRISFILTERS_EXPORT std::vector<Vec3> SharpenedPoints(Mesh mesh, const Connectivity& connectivity,
  const std::vector<int>& thinningRounds, const Skeleton& skeleton, double windowRadius,
  double averageEdgeLength, const Monitor& monitor);
}

#endif
