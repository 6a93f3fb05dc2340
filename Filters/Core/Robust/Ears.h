// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Ears.h
/// Makes room for triangles that have all corners where patches of an assembly meet.

#ifndef arris_Robust_Ears_h
#define arris_Robust_Ears_h

#include "Placement.h"

namespace arris
{
/// Where the curve between patches runs straight, or bends the other way, a triangle with all its
/// corners on it has no area, or is folded over; no other face can take it, as it may within one
/// patch. Its middle corner is lifted off the curve along the triangle's face, by hardly more than
/// gives it area: so no face is creased, and the curve is where it was to within `MostLift`.
ARRISFILTERS_EXPORT void LiftEars(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<double>& scales, Placement& placement);
}

#endif
