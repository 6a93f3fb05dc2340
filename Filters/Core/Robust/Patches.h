// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Patches.h
/// The intact vertices sorted into patches of nearly one normal.

#ifndef arris_Robust_Patches_h
#define arris_Robust_Patches_h

#include "Faces.h"

namespace arris
{
struct Patches
{
  std::vector<Index> PatchOf; ///< for each vertex its patch; NoIndex in the sharp region
  std::vector<Index> PieceOf; ///< the connected piece of intact surface it is in; NoIndex likewise
  Index PatchCount = 0;
  Index PieceCount = 0;
};

/// Lets isolated remains of the intact surface (under three vertices, or without a whole triangle)
/// join the sharp region, then floods patches from the flattest vertices on.
Patches SortIntoPatches(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& flatness, Flags& region);

/// Sorts vertices that have left the region (see ReleaseUnexplained) into patches of their own.
void AddNarrowPatches(const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& flatness, const Flags& region, const std::vector<Index>& released,
  Patches& patches);
}

#endif
