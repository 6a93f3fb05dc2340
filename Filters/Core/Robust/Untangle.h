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
/// that makes the triangles around better.
void Untangle(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales,
  Placement& placement);
}

#endif
