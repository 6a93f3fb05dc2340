// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureSelection.h
/// The steps that choose a mesh's feature edges, in their order.
///
///  0. FindFolds, which others need as well.
///  1. CandidateEdges: all that fold by more than the lower angle, the boundary, non-manifold
///  edges.
///  2. QuietAngles: what of their angles is noise.
///  3. ChooseEdges: above the upper angle, or above the lower one and going on from there.
///  4. CloseGaps, CutTails, CloseFoldedGaps.

#ifndef arris_Features_FeatureSelection_h
#define arris_Features_FeatureSelection_h

#include "FeatureCriteria.h"

namespace arris
{
/// Finds the feature edges of a mesh, sorted by A, then B. False if the monitor stopped it.
ARRISFILTERS_EXPORT bool SelectFeatures(const Mesh& mesh, const Connectivity& connectivity,
  const Folds& folds, const FeatureCriteria& criteria, const Monitor& monitor,
  std::vector<FeatureEdge>& edges);
}

#endif
