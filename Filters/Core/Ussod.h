// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Ussod.h
/// The Uniformly Supported Second-Order Difference and the sharp region (sections 3.1 and 4.2).

#ifndef arris_Ussod_h
#define arris_Ussod_h

#include "Mesh.h"
#include "Parallel.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// How the triangles of a window are found.
enum class WindowSearch
{
  Connected, ///< by walking the mesh: only what the surface connects inside the window
  Spatial ///< in space, as the paper does: also walls that are close but not connected
};

/// For each vertex the largest 1 - ni.nj between two triangles within the window radius λ of it
/// (0 to 2): λτ(v) of Eq. 2. Vertices without triangles get 0. Empty if the monitor stopped it.
ARRISFILTERS_EXPORT std::vector<double> NormalDifferences(const Mesh& mesh,
  const Connectivity& connectivity, const std::vector<Vec3>& unitNormals, double windowRadius,
  WindowSearch search, const Monitor& monitor);

/// The sharp region Ω: 1 for each vertex whose normal difference reaches that of `sharpAngle`
/// (degrees), which is τ(v) >= κ with κλ = 1 - cos(sharp angle).
ARRISFILTERS_EXPORT Flags SharpRegion(
  const std::vector<double>& normalDifferences, double sharpAngle);
}

#endif
