// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Tails.h
/// Drops curves that are too short to be features.

#ifndef arris_Features_Tails_h
#define arris_Features_Tails_h

#include "FeatureCriteria.h"

namespace arris
{
/// Drops the folds that belong to a tail, a curve with a free end, shorter than TailLength, or than
/// UnlikelyLength if features are expected elsewhere: at less than half of its edges (and at any of
/// the mesh). Then those of any curve shorter than MinimumLength. As often as that makes new ones.
/// A tail reaches up to where other than two edges meet or it turns; one that ends on the boundary
/// of the mesh does not end freely. The boundary and non-manifold edges stay.
ARRISFILTERS_EXPORT void CutTails(const std::vector<Vec3>& points, const Flags& onBoundary,
  const FeatureCriteria& criteria, std::vector<FeatureEdge>& edges);
}

#endif
