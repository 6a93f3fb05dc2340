// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Primitive.h
/// The shapes that faces of machined parts have.

#ifndef arris_Fits_Primitive_h
#define arris_Fits_Primitive_h

#include "Core/Types.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// In order of how much there is to choose about them.
enum class PrimitiveKind : unsigned char
{
  Plane,
  Sphere,
  Cylinder,
  Cone,
  Torus,
  FreeForm
};

/// "plane", "sphere" ... "free-form".
ARRISFILTERS_EXPORT const char* NameOf(PrimitiveKind kind);

/// One of the shapes; a parameter that its kind does not have is 0.
struct ARRISFILTERS_EXPORT Primitive
{
  PrimitiveKind Kind = PrimitiveKind::FreeForm;
  Vec3 Point = Vec3::Zero(); ///< on the plane or the axis; the centre; the apex of a cone
  Vec3 Axis = Vec3::Zero(); ///< unit; normal of a plane; of a cone from its apex to its inside
  double Radius = 0.0; ///< of a torus, of the circle in the middle of its tube
  double MinorRadius = 0.0; ///< of the tube
  double HalfAngle = 0.0; ///< of a cone, between axis and flank, radians

  /// How far a point is from the shape; negative on the side of its axis or centre, and where a
  /// plane's normal does not point.
  double Distance(const Vec3& point) const;

  /// The direction in which the distance grows; of length 1, or 0 where there is none.
  Vec3 Normal(const Vec3& point) const;
};
}

#endif
