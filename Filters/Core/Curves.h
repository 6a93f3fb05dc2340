// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Curves.h
/// Joins edges end to end into curves, split at corners.

#ifndef arris_Curves_h
#define arris_Curves_h

#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// A run of mesh vertices; a closed one names its first vertex again at its end.
using Curve = std::vector<Index>;

/// A vertex where curves end.
struct CurveCorner
{
  Index Vertex;
  int Valence; ///< how many edges end there: 1 a free end, 2 a turn, 3 and more a true corner
};

struct CurveNetwork
{
  std::vector<Curve> Curves;
  std::vector<CurveCorner> Corners; ///< ascending by vertex
};

/// Joins edges (a, b) into curves that end at vertices whose number of edges is not two, and where
/// the curve turns by more than `cornerAngle` (degrees; 180 for no such turns). Curves between
/// corners come first, from the lowest corner on; then the closed ones, each from its lowest
/// vertex.
ARRISFILTERS_EXPORT CurveNetwork JoinEdges(const std::vector<std::array<Index, 2>>& edges,
  const std::vector<Vec3>& points, double cornerAngle);
}

#endif
