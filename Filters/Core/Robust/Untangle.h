// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Untangle.h
/// Mends triangles that placement has folded over or left without area.

#ifndef arris_Robust_Untangle_h
#define arris_Robust_Untangle_h

#include "Placement.h"

namespace arris
{
/// Slides vertices along their face or ridge, and gives single triangles to another face, wherever
/// that makes the triangles around better: of these triangles, and of what is changed by that. The
/// first to be mended decides what room there is for the others; they come in the order of their
/// numbers, or shuffled in as many ways as there are other values of `order` than 0.
///
/// Returns the vertices that it has moved at some time, ascending.
std::vector<Index> Untangle(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<double>& scales, std::vector<Index> triangles, int order, Placement& placement);
}

#endif
