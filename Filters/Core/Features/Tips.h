// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Tips.h
/// Points like the apex of a cone: sharp, and no edge leads there.

#ifndef arris_Features_Tips_h
#define arris_Features_Tips_h

#include "Folds.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
enum class TipKind : unsigned char
{
  None,
  Out,
  In
};

/// The least Difference of the steepest fold at a tip, but where there are too many to tell. The
/// normals around a vertex run round a curve on the unit sphere, as long as the angles of the folds
/// together, and what the angles at the vertex lack to a full turn is the area inside: of all
/// curves a circle has the most. So one fold of as many as there are in a fan must be this part of
/// that; an angle is no more than pi / sqrt(2) times the root of the difference of its normals.
ARRISFILTERS_EXPORT double LeastFoldAtTips(double tipAngle);

/// For each vertex whether it is a tip: see FindFeatureCorners. Vertices that are flagged `edged`,
/// on the boundary or on non-manifold edges are none. Empty if the monitor stopped it.
ARRISFILTERS_EXPORT std::vector<TipKind> FindTips(const Mesh& mesh,
  const Connectivity& connectivity, const Folds& folds, const Flags& edged, double tipAngle,
  const Monitor& monitor);
}

#endif
