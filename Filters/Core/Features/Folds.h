// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Folds.h
/// How the surface folds at each edge of a mesh.

#ifndef arris_Features_Folds_h
#define arris_Features_Folds_h

#include "Core/Geometry.h"
#include "Core/Mesh.h"
#include "Core/Parallel.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// What meets at an edge.
enum class EdgeKind : unsigned char
{
  Convex, ///< two triangles, and the material (behind their normals) is within the angle
  Concave, ///< two triangles, and the material is outside the angle
  Boundary, ///< one triangle
  NonManifold ///< three and more
};

/// For edge k of each triangle, how much the surface folds there.
struct Folds
{
  /// 1 - n1.n2 of the triangles at the edge, negative where it is concave; 0 on the boundary; the
  /// largest of any two triangles at a non-manifold edge. A triangle wound against its neighbour is
  /// read the other way round.
  Unfilled<std::array<float, 3>> Differences;
  Unfilled<std::array<EdgeKind, 3>> Kinds;
};

/// The folds of all edges; without entries if the monitor stopped it. A triangle so thin that the
/// rounding of single-precision points decides where it looks has no say: it is taken to lie in the
/// plane of the triangle across its longest edge.
ARRISFILTERS_EXPORT Folds FindFolds(
  const Mesh& mesh, const Connectivity& connectivity, const Monitor& monitor);

/// Whether two triangles at the edge from `a` to `b` are wound alike: then they run through it in
/// opposite directions.
inline bool WoundAlike(const Triangle& one, const Triangle& other, Index a, Index b)
{
  return one[EdgeBetween(one, a, b)] != other[EdgeBetween(other, a, b)];
}
}

#endif
