// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Resampling.h
/// Points at even distances along a curve.

#ifndef arris_Features_Resampling_h
#define arris_Features_Resampling_h

#include "Core/Curves.h"

#include <string>

namespace arris
{
/// So many points more than the curves of a mesh have may be put on them. A mesh of ten million
/// triangles has some ten thousand edges that are sharp: a hundred on each.
constexpr double MostPointsAdded = 1e6;

/// A point on the edge that follows a curve's vertex.
struct CurvePoint
{
  std::size_t At; ///< which vertex of the curve
  double Share; ///< of the way to the next one; 0 at the vertex itself
};

/// The vertices of a curve as points on it; the last one of a closed curve is left out.
ARRISFILTERS_EXPORT std::vector<CurvePoint> VerticesOf(const Curve& curve);

/// Points on a curve, `step` apart along it, or as near to that as goes evenly into its length.
/// Both ends are among them; a closed curve has three points at least, and begins with its first
/// vertex. The step must be one that ProblemWithStep finds nothing wrong with.
ARRISFILTERS_EXPORT std::vector<CurvePoint> Resampled(
  const Curve& curve, const std::vector<Vec3>& points, double step);

/// What is wrong with the step between the points on curves, or nothing: one that is so small that
/// they would not fit into memory.
ARRISFILTERS_EXPORT std::string ProblemWithStep(
  const std::vector<Curve>& curves, const std::vector<Vec3>& points, double step);
}

#endif
