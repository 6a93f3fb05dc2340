// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Noise.h
/// Tells folds of the shape from those of noise.

#ifndef arris_Features_Noise_h
#define arris_Features_Noise_h

#include "FeatureEdges.h"

namespace arris
{
/// The angle that each edge is chosen by, in degrees: its own where the mesh around is quiet. Where
/// the mesh is noisy, folding up and down by more than the edge's angle over `noiseFactor`, it is
/// the angle between the mean normals of both sides, up to three edge lengths away, if that is
/// less: noise cancels out there, an edge does not. `noiseFactor` 0: always its own. Without
/// entries if the monitor stopped it.
ARRISFILTERS_EXPORT std::vector<double> QuietAngles(const Mesh& mesh,
  const Connectivity& connectivity, const Folds& folds, const std::vector<FeatureEdge>& edges,
  double noiseFactor, const Monitor& monitor);
}

#endif
