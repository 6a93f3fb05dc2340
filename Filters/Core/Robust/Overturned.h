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
/// Whether triangles with these area vectors lie on each other, if they have an edge in common:
/// within 10 degrees.
inline bool AreFolded(const Vec3& a, const Vec3& b)
{
  constexpr double FoldedSquare = 0.969846310; // of the cosine between their normals
  const double dot = a.dot(b);
  return dot < 0.0 && dot * dot > FoldedSquare * a.squaredNorm() * b.squaredNorm();
}

/// Whether it counts if these neighbours lie on each other: they did not in `mesh`.
bool MayFold(const Mesh& mesh, const Connectivity& connectivity, Index triangle, Index beyond);

/// Whether an area vector faces against a triangle of `mesh` and all that share a vertex with it.
/// Else `other` is one that it does not face against.
bool FacesAgainstAll(const Mesh& mesh, const Connectivity& connectivity, const Vec3& area,
  Index triangle, Vec3& other);

/// Whether a triangle whose vertices are at `points` now is turned over: it lies on a neighbour,
/// and did not in `mesh`; or it faces against itself and all that shared a vertex with it in
/// `mesh`: triangles that cut an edge off lie between its faces, so near a triangle that is
/// restored one has always faced as it does.
ARRISFILTERS_EXPORT bool IsOverturned(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Vec3>& points, Index triangle);
}

#endif
