// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file RegionOutline.h
/// The line around the sharp region, for pictures.

#ifndef arris_RegionOutline_h
#define arris_RegionOutline_h

#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// A piece of the line, inside one triangle.
struct OutlineSegment
{
  Vec3 Begin, End;
  Index Triangle;
};

/// Where the values of the vertices, interpolated linearly, pass `threshold`; a value that reaches
/// it is inside. One segment for each triangle with corners on both sides.
ARRISFILTERS_EXPORT std::vector<OutlineSegment> RegionOutline(
  const Mesh& mesh, const std::vector<double>& values, double threshold);
}

#endif
