// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FoldAlong.h
/// Whether a surface folds along a way, seen from farther away than a triangle.

#ifndef arris_Features_FoldAlong_h
#define arris_Features_FoldAlong_h

#include "FeatureEdges.h"

namespace arris
{
/// Whether the mean normals to both sides of a way along mesh edges, as far as it is long and up to
/// the next features, differ by more than `angle` degrees, and by four times as much as those of
/// the nearer and the farther half of either side: so it is not just curved.
ARRISFILTERS_EXPORT bool FoldsAlong(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& sortedFeatures, const std::vector<Index>& way, double angle);
}

#endif
