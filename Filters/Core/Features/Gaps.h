// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Gaps.h
/// Closes gaps between feature edges.

#ifndef arris_Features_Gaps_h
#define arris_Features_Gaps_h

#include "FeatureEdges.h"

namespace arris
{
/// Carries on each free end along mesh edges to the nearest other feature, if one is ahead (within
/// 60 degrees) and the way there no longer than `length`. Edges stay sorted.
ARRISFILTERS_EXPORT void CloseGaps(const Mesh& mesh, const Connectivity& connectivity,
  const Folds& folds, double length, std::vector<FeatureEdge>& edges);

/// Likewise to a feature farther away, straight ahead (within 30 degrees of the last three edges),
/// where the surface folds between by more than `angle` degrees, whatever its single triangles do:
/// see FoldsAlong.
ARRISFILTERS_EXPORT void CloseFoldedGaps(const Mesh& mesh, const Connectivity& connectivity,
  const Folds& folds, double length, double angle, std::vector<FeatureEdge>& edges);
}

#endif
