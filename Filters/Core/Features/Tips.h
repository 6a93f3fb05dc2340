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

/// For each vertex whether it is a tip: see FindFeatureCorners. Vertices that are flagged `edged`,
/// on the boundary or on non-manifold edges are none. Empty if the monitor stopped it.
ARRISFILTERS_EXPORT std::vector<TipKind> FindTips(const Mesh& mesh,
  const Connectivity& connectivity, const Folds& folds, const Flags& edged, double tipAngle,
  const Monitor& monitor);
}

#endif
