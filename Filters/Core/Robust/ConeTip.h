// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ConeTip.h
/// Where the tip of a cone is, or was before a blur.
///
/// A Gaussian of width σ moves a surface by σ²/2 times the sum of its curvatures: a cone whose
/// sides are at an angle α to its axis by σ² / (2 s tan α), at a distance s from the tip. Its
/// tangent planes, which met in the tip, then pass it at twice that: at c / s, with a c that is
/// unknown as the tip is.

#ifndef arris_Robust_ConeTip_h
#define arris_Robust_ConeTip_h

#include "Core/Types.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The tangent planes of a surface at some of its points.
struct TangentPlanes
{
  std::vector<Vec3> Points;
  std::vector<Vec3> Normals; ///< unit
};

/// Along the axis, and the shorter the more they look all around.
ARRISFILTERS_EXPORT Vec3 SumOfNormals(const TangentPlanes& planes);

struct ConeTip
{
  Vec3 Point;
  double Misfit; ///< root mean square distance of the planes from where they should pass
  double Blur; ///< how far from the tip the nearest plane passes; 0 without a blur
};

/// Where the planes meet.
ARRISFILTERS_EXPORT ConeTip FindConeTip(const TangentPlanes& planes);

/// Where they met before a blur.
ARRISFILTERS_EXPORT ConeTip FindBlurredConeTip(const TangentPlanes& planes);

/// Where a point of a blurred cone was before the blur: on the plane through the tip that is turned
/// like the nearest of these around the axis. Towards these, to which the surface goes on as it is,
/// the way fades.
ARRISFILTERS_EXPORT Vec3 OnCone(const TangentPlanes& planes, const Vec3& tip, const Vec3& point);
}

#endif
