// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Settled.h
/// Which damaged vertices a later pass leaves as the pass before has placed them.

#ifndef arris_Robust_Settled_h
#define arris_Robust_Settled_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// What is far from all that is new would be placed once more by the same faces.
struct Settled
{
  Flags Vertices; ///< 1 for vertices that stay as they are, damaged or not
  Flags Unfitted; ///< 1 for those that are so far away that no open vertex asks for their sides
};

/// Around the `open` vertices: where the pass before was not the last word.
ARRISFILTERS_EXPORT Settled FindSettled(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<double>& scales, const std::vector<Index>& open);
}

#endif
