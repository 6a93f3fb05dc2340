// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file CoincidentPoints.h
/// Which points are one and the same, but for rounding.

#ifndef arris_Assembly_CoincidentPoints_h
#define arris_Assembly_CoincidentPoints_h

#include "Core/Types.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// For each of the listed vertices (ascending) the one it is taken for: the lowest that is not
/// taken for another and is no farther than `tolerance` away; mostly itself. Depends on nothing but
/// the positions and their order.
ARRISFILTERS_EXPORT std::vector<Index> LowestCoincident(
  const std::vector<Vec3>& points, const std::vector<Index>& vertices, double tolerance);

/// Those of the listed vertices that a chain of steps no longer than `tolerance` from one to the
/// next may lead to from the seeds, which are among them: all that LowestCoincident has to see to
/// tell what the seeds are one with.
ARRISFILTERS_EXPORT std::vector<Index> MayCoincideWith(const std::vector<Index>& seeds,
  const std::vector<Vec3>& points, const std::vector<Index>& vertices, double tolerance);
}

#endif
