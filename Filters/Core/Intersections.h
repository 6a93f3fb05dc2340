// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Intersections.h
/// Finds where a surface runs through itself.

#ifndef arris_Intersections_h
#define arris_Intersections_h

#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <array>
#include <vector>

namespace arris
{
/// Pairs of triangles that cut through each other, of which at least one is among `triangles`; the
/// lower index first, sorted, each pair once. `triangles` may come in any order.
///
/// To cut through is to have inner points in common and corners on both sides of the other's plane.
/// What only touches does not count, nor does what gets no farther than 1e-10 of the longest edge,
/// or than rounding may have moved the points. So:
///  - triangles that share a vertex count if they meet along a line that leaves it;
///  - triangles that share an edge, or all three, count if they are folded flat onto each other;
///  - other triangles in one plane do not count, though they overlap, and neither does a surface
///    that goes through another one exactly along its own edges;
///  - triangles without area count in no pair.
/// Vertices are shared by index, but coincident ones are no trouble: they touch.
ARRISFILTERS_EXPORT std::vector<std::array<Index, 2>> FindIntersections(
  const MeshView& mesh, const std::vector<Index>& triangles);
}

#endif
