// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file CurveProperties.h
/// Which way feature curves run, and what there is to say about each.

#ifndef arris_Features_CurveProperties_h
#define arris_Features_CurveProperties_h

#include "Core/Curves.h"
#include "FeatureEdges.h"

namespace arris
{
/// Angles in degrees.
struct CurveProperties
{
  double Length;
  double MeanAngle; ///< by length
  double LeastAngle;
  double LargestAngle;
  EdgeKind Kind; ///< convex or concave by what prevails
  bool Closed;
  Index LeftSurface; ///< beside who walks along the curve on the outside; NoIndex: none
  Index RightSurface;
};

/// Turns each curve so that the surface of the lower number is on its left, on the boundary the
/// only one. A curve within one surface runs from its lower end on.
ARRISFILTERS_EXPORT void OrientCurves(const std::vector<FeatureEdge>& sortedFeatures,
  const std::vector<Index>& surfaceIds, std::vector<Curve>& curves);

ARRISFILTERS_EXPORT CurveProperties DescribeCurve(const Curve& curve,
  const std::vector<FeatureEdge>& sortedFeatures, const std::vector<Index>& surfaceIds,
  const std::vector<Vec3>& points);

/// At each vertex of a curve (the last one of a closed curve is left out) its direction: the mean
/// of those of the edges before and after, a unit vector; zero where the curve turns back on
/// itself.
ARRISFILTERS_EXPORT std::vector<Vec3> Tangents(const Curve& curve, const std::vector<Vec3>& points);

/// At each vertex, likewise, the mean dihedral angle of the edges before and after, in degrees.
ARRISFILTERS_EXPORT std::vector<double> AnglesAlong(
  const Curve& curve, const std::vector<FeatureEdge>& sortedFeatures);
}

#endif
