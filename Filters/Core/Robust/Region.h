// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Region.h
/// The sharp region found without parameters.

#ifndef arris_Robust_Region_h
#define arris_Robust_Region_h

#include "Turn.h"

namespace arris
{
struct SharpRegion
{
  Flags Vertices; ///< 1 for those that sampling has taken off the surface beside an edge or corner
  double Rounding; ///< 0 where the mesh's edges were cut off, 1 where they were rounded as well
};

SharpRegion FindSharpRegion(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Turn>& turns, const std::vector<double>& scales);

/// Whether the turn is that of an edge: sharp enough, and more concentrated than a curved side's.
bool ShowsEdge(const Turn& turn);
}

#endif
