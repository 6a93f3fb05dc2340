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

/// Where curves are split, other than at vertices whose number of edges is not two.
struct CurveSplits
{
  /// Where a curve turns by more than this, in degrees; 180 for never.
  double CornerAngle = 180.0;

  /// The turn counts that is seen both between the edges at a vertex and between the chords to
  /// where the curve is this long a way before and after: so a kink of a tiny edge is none, nor is
  /// a tight arc. 0 looks at the edges at the vertex alone.
  double Reach = 0.0;

  /// A number for each edge: a curve is split where it changes. Empty: all are alike.
  std::vector<int> Sorts = {};

  /// Whether turns that are taken back at once split no curve: see Kinks.h.
  bool ForgetKinks = false;
};

/// Joins edges (a, b) into curves. Curves between corners come first, from the lowest corner on;
/// then the closed ones, each from its lowest vertex.
ARRISFILTERS_EXPORT CurveNetwork JoinEdges(const std::vector<std::array<Index, 2>>& edges,
  const std::vector<Vec3>& points, const CurveSplits& splits = {});

inline bool IsClosed(const Curve& curve)
{
  return curve.size() > 2 && curve.front() == curve.back();
}

ARRISFILTERS_EXPORT double LengthOf(const Curve& curve, const std::vector<Vec3>& points);
}

#endif
