// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Region.h
/// The sharp region found without parameters.

#ifndef arris_Robust_Region_h
#define arris_Robust_Region_h

#include "Roughness.h"
#include "Turn.h"

namespace arris
{
struct SharpRegion
{
  Flags Vertices; ///< 1 for those that sampling has taken off the surface beside an edge or corner
  double Rounding; ///< 0 where the mesh's edges were cut off, 1 where they were rounded as well
};

/// A rounding from which on it is a blur's, of all edges; below, that of some.
constexpr double BlurRounding = 0.5;

/// From which turn on an edge is sharp, in degrees.
struct EdgeAngles
{
  double Seed = 16.0; ///< a vertex whose jump is this large is sharp by itself
  double Grown = 12.0; ///< beside one that is, this is enough
  double Corner = 55.0; ///< no smooth surface that is sampled turns so in a window

  /// Suits the mesh, unless the user has set an angle (not 0).
  static EdgeAngles Of(const Roughness& rough, double setAngle);
};

SharpRegion FindSharpRegion(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Turn>& turns, const std::vector<double>& scales, const EdgeAngles& angles);

/// Whether the turn is that of an edge: sharp enough, and more concentrated than a curved side's.
bool ShowsEdge(const Turn& turn, const EdgeAngles& angles);
}

#endif
