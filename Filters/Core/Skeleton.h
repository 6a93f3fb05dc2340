// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Skeleton.h
/// The single-edge-wide skeleton of the sharp region and the parts its vertices play
/// (sections 4.4 and 4.5).

#ifndef arris_Skeleton_h
#define arris_Skeleton_h

#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The part a vertex plays in the skeleton; the values of the array `SkeletonRole`.
enum class SkeletonRole : unsigned char
{
  None = 0, ///< not on the skeleton
  Branch = 1, ///< two sharp edges
  Joint = 2, ///< three or more sharp edges
  End = 3 ///< one sharp edge, or none
};

/// The skeleton Ψ: which mesh edges are sharp, and the vertices by their part.
struct ARRISFILTERS_EXPORT Skeleton
{
  /// For each vertex of the mesh those it shares a sharp edge with, ascending.
  Rows SharpNeighbors;

  /// For each vertex of the mesh.
  std::vector<SkeletonRole> Roles;

  /// The sharp edges, each once, its lower vertex first, ascending.
  std::vector<std::array<Index, 2>> Edges() const;
};

/// Tells the skeleton from the rounds that thinning gave. Mesh edges between two skeleton vertices
/// are sharp, but where a triangle has three of them only the two at its greatest angle stay
/// (Fig. 7); of equal angles the one at the lower vertex counts as greater.
ARRISFILTERS_EXPORT Skeleton TraceSkeleton(
  const Mesh& mesh, const Connectivity& connectivity, const std::vector<int>& thinningRounds);
}

#endif
