// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Creases.h
/// How creased a mesh is: over its edges, the length times the square root of the dihedral angle.
///
/// A turn of the surface costs least when one edge has all of it, and an edge costs least when it
/// is straight. So a recovery that is right lowers the sum: two bends of 45 degrees make way for
/// one of 90. One that is wrong raises it, by notches, spikes and folds. (Any concave function of
/// the angle does this; a convex one, as the squared turn of bending energies, favours what is
/// rounded.)

#ifndef arris_Robust_Creases_h
#define arris_Robust_Creases_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <limits>

namespace arris
{
/// The creases of the edges of all triangles at a vertex, were the mesh's vertices at `points`, but
/// this one `at` another. In units of length times the root of an angle in radians. Not added up to
/// the end where they are `enough` before.
ARRISFILTERS_EXPORT double CreasesAround(const std::vector<Triangle>& triangles,
  const Connectivity& connectivity, const std::vector<Vec3>& points, Index vertex, const Vec3& at,
  double enough = std::numeric_limits<double>::infinity());

/// The same with all of them at `points`.
inline double CreasesAround(const std::vector<Triangle>& triangles,
  const Connectivity& connectivity, const std::vector<Vec3>& points, Index vertex)
{
  return CreasesAround(triangles, connectivity, points, vertex, points[vertex]);
}
}

#endif
