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

/// How much the surface folds at an edge.
struct EdgeFold
{
  /// 1 - n1.n2 of the triangles at the edge, negative where it is concave; 0 on the boundary; the
  /// largest of any two triangles at a non-manifold edge. A triangle wound against its neighbour is
  /// read the other way round.
  float Difference;
  EdgeKind Kind;
};

/// Edge `Edge` of a triangle, the lowest one there, and the size of its Difference.
struct SteepEdge
{
  Index Triangle;
  int Edge;
  float Difference;
};

/// What tells how a mesh folds. Nearly all edges of most meshes fold too little for anyone to ask:
/// what the others do is found when asked, from the normals.
struct Folds
{
  /// A triangle so thin that the rounding of single-precision points decides where it looks has no
  /// say: it is taken to lie in the plane of the triangle across its longest edge. Zero where there
  /// is none.
  Unfilled<Eigen::Vector3f> Normals;

  /// All edges with a Difference of this at least, those on the boundary and the non-manifold ones,
  /// in no order.
  double Least = 0.0;
  std::vector<SteepEdge> Steep;

  /// Of all edges, in noise: where a tenth of them are steep, what the others do is asked again and
  /// again. Else empty.
  Unfilled<std::array<float, 3>> Differences;
};

/// The normals and the steep edges; without either if the monitor stopped it.
ARRISFILTERS_EXPORT Folds FindFolds(
  const Mesh& mesh, const Connectivity& connectivity, const Monitor& monitor, double least = 0.0);

/// The fold of edge k of triangle t.
ARRISFILTERS_EXPORT EdgeFold FoldAt(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t, int k);

/// The size of its Difference, which takes less time.
ARRISFILTERS_EXPORT float FoldSize(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t, int k);

/// Whether two triangles at the edge from `a` to `b` are wound alike: then they run through it in
/// opposite directions.
inline bool WoundAlike(const Triangle& one, const Triangle& other, Index a, Index b)
{
  return one[EdgeBetween(one, a, b)] != other[EdgeBetween(other, a, b)];
}
}

#endif
