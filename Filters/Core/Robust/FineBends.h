// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FineBends.h
/// Tells a mesh whose bends are meant from one whose edges a blur has rounded.
///
/// Sampling makes triangles of one size everywhere, and a blur leaves them so. Who tessellates a
/// fillet, or scans a part and simplifies the scan, gives bends finer triangles than faces, to
/// keep their shape.

#ifndef arris_Robust_FineBends_h
#define arris_Robust_FineBends_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Bends whose triangles are smaller than this, by those of faces, are meant. Of sampled solids the
/// least is 1.0 where edges were rounded (segmentations, blurred distances); scans and
/// tessellations have 0.35 to 0.6.
constexpr double MeantBendSize = 0.75;

/// The mean area of the triangles with all three vertices in the region, by that of the triangles
/// with none; 1 where there are none of either.
ARRISFILTERS_EXPORT double BendTriangleSize(const Mesh& mesh, const Flags& region);
}

#endif
