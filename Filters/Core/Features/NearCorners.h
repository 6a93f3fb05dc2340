// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file NearCorners.h
/// Corners that are one but for a tiny edge.

#ifndef arris_Features_NearCorners_h
#define arris_Features_NearCorners_h

#include "Core/Curves.h"

namespace arris
{
/// Makes one corner of two that a curve of less than a tenth of the edges around joins: a mesh does
/// not tell such apart. The corner with more curves stays, of equal ones the lower vertex, and the
/// curves of the other one go on to it along the tiny curve, which is none any more. Only where the
/// curves are sampled, with four edges or more each, as a CAD tessellation's are not, and no two
/// from different ends run the same way, as along a thin plate.
ARRISFILTERS_EXPORT void MergeNearCorners(const std::vector<Vec3>& points, CurveNetwork& network);
}

#endif
