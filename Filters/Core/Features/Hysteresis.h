// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Hysteresis.h
/// Chooses feature edges by two angles: where they begin and how far they go on.

#ifndef arris_Features_Hysteresis_h
#define arris_Features_Hysteresis_h

#include "FeatureEdges.h"

namespace arris
{
/// Angles in degrees.
struct AngleBand
{
  double Seed; ///< edges above are features
  double Continuation; ///< and those above this that go on where a feature ends
  double Largest; ///< edges above are none: folded back, for instance
  double Turn; ///< a feature goes on straight but for this angle
};

/// Of candidates sorted by their ends, with the angles to choose by, those that are features: folds
/// in the band, and the boundary and non-manifold edges as asked for. Where one ends freely, the
/// candidate of its kind that folds most and goes on without a turn is one too. An edge between two
/// vertices that are flagged `likely` (if there are flags) need only be above the lower angle.
ARRISFILTERS_EXPORT std::vector<FeatureEdge> ChooseEdges(const std::vector<FeatureEdge>& candidates,
  const std::vector<double>& angles, const std::vector<Vec3>& points, const AngleBand& band,
  bool boundary, bool nonManifold, const Flags& likely);
}

#endif
