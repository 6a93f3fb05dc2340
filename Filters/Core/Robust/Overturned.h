// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Overturned.h
/// Which triangles of a moved mesh lie on their neighbours or face against all there was, told
/// from the mesh alone.

#ifndef arris_Robust_Overturned_h
#define arris_Robust_Overturned_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Whether a triangle whose vertices are at `points` now is turned over: it lies on a neighbour,
/// and did not in `mesh`; or it faces against itself and all that shared a vertex with it in
/// `mesh`: triangles that cut an edge off lie between its faces, so near a triangle that is
/// restored one has always faced as it does.
ARRISFILTERS_EXPORT bool IsOverturned(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Vec3>& points, Index triangle);
}

#endif
