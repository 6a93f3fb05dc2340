// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Resampling.h
/// Points at even distances along a curve.

#ifndef arris_Features_Resampling_h
#define arris_Features_Resampling_h

#include "Core/Curves.h"

namespace arris
{
/// No curve gets more points than this, however small the step.
constexpr std::size_t MostSteps = 1000000;

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
/// vertex.
ARRISFILTERS_EXPORT std::vector<CurvePoint> Resampled(
  const Curve& curve, const std::vector<Vec3>& points, double step);
}

#endif
