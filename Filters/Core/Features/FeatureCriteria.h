// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureCriteria.h
/// What makes an edge a feature.

#ifndef arris_Features_FeatureCriteria_h
#define arris_Features_FeatureCriteria_h

#include "Hysteresis.h"

namespace arris
{
/// Angles in degrees, lengths in the mesh's unit; 0 turns a length off.
struct FeatureCriteria
{
  AngleBand Band; ///< curves are split where they turn by more than its Turn
  double CornerReach; ///< see CurveSplits
  double NoiseFactor; ///< see QuietAngles
  bool Boundary;
  bool NonManifold;
  double GapLength;
  double FoldedGapLength; ///< see CloseFoldedGaps
  double TailLength; ///< see CutTails, and the next
  double UnlikelyLength;
  double MinimumLength;
  Flags Likely; ///< vertices where features are expected; may be empty
};
}

#endif
