// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Mending.h
/// What is left to do once vertices are on their faces: triangles have folded over, ridges are
/// notched, and faces cut each other.

#ifndef arris_Robust_Mending_h
#define arris_Robust_Mending_h

#include "Labelled.h"
#include "Placement.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <functional>

namespace arris
{
struct Mending
{
  bool IsSmoothed; ///< whether what is intact has moved as well, in a smooth copy of a rough mesh
  bool KeepsSmooth; ///< and is to stay where it is there
  bool IsLast; ///< whether no pass comes after this one
  std::function<void(Placement&)> FlipEdges; ///< empty if none may be flipped
};

/// Mends the triangles of the damaged vertices. Returns where vertices would be if nothing had
/// folded or cut.
ARRISFILTERS_EXPORT std::vector<Vec3> Mend(const Labelled& mesh, const std::vector<Index>& damaged,
  const Mending& mending, Placement& placement);
}

#endif
