// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Tails.h
/// Drops curves that are too short to be features.

#ifndef arris_Features_Tails_h
#define arris_Features_Tails_h

#include "FeatureEdges.h"

namespace arris
{
/// Drops the folds that belong to a tail, a curve with a free end, shorter than `tailLength`; then
/// those of any curve shorter than `minimumLength`. As often as that makes new ones. Curves run
/// between vertices where other than two edges meet; one that ends on the boundary of the mesh does
/// not end freely. The boundary and non-manifold edges stay.
ARRISFILTERS_EXPORT void CutTails(const std::vector<Vec3>& points, const Flags& onBoundary,
  double tailLength, double minimumLength, std::vector<FeatureEdge>& edges);
}

#endif
