// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file RightAlready.h
/// What needs no recovery: triangles that lie on a face, and vertices where such faces meet.

#ifndef arris_Robust_RightAlready_h
#define arris_Robust_RightAlready_h

#include "Labelling.h"

namespace arris
{
struct RightAlready
{
  std::vector<Index> Labels; ///< for each triangle the face it lies on; NoIndex if none or unknown
  Flags OnRidge; ///< 1 for damaged vertices around which all triangles lie on faces, on several
};

/// Finds what has its sharp edge still: on a tessellated solid, or on a mesh recovered before.
RightAlready FindRightAlready(const Mesh& mesh, const Connectivity& connectivity,
  const Faces& faces, const std::vector<double>& scales, const Labelling& labelling);
}

#endif
