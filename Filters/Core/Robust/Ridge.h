// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Ridge.h
/// Where labels meet: which vertices become the skeleton, and which face each triangle is part of.

#ifndef arris_Robust_Ridge_h
#define arris_Robust_Ridge_h

#include "RightAlready.h"

namespace arris
{
struct Ridge
{
  Flags OnRidge; ///< 1 for the skeleton's vertices
  std::vector<Index> FaceLabels; ///< for each triangle its label, NoIndex away from the region
};

Ridge FindRidge(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const Labelling& labelling, const RightAlready& right);
}

#endif
