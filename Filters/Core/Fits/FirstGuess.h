// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FirstGuess.h
/// Shapes near to a face in closed form, from where Refine goes on.

#ifndef arris_Fits_FirstGuess_h
#define arris_Fits_FirstGuess_h

#include "Primitive.h"

namespace arris
{
/// Triangles of a face, or enough of them.
struct FaceSample
{
  struct Item
  {
    std::array<Vec3, 3> Corners;
    Vec3 Centroid;
    Vec3 Normal; ///< unit
    double Weight; ///< part of all areas
  };
  std::vector<Item> Items;
};

// Each of them tells whether it found something; then it is in `shape`.
//
// Plane: through the centroid, normal to where the corners extend least.
// Sphere: |p|^2 = 2 p.c + (r^2 - |c|^2) is linear in what is sought.
// Cylinder: the normals are perpendicular to the axis; seen along it, the corners lie on a circle.
// Cone: the normals make one angle with the axis, so their ends lie in a plane across it; the
// planes
//   of all triangles meet at the apex.
// Torus: the normals of a surface of revolution are lines that all meet its axis, which is linear
// in
//   the Plücker coordinates of the axis (Pottmann and Randrup, "Rotational and helical surface
//   approximation for reverse engineering", Computing 60, 1998); seen around the axis, the corners
//   lie on a circle.
ARRISFILTERS_EXPORT bool GuessPlane(const FaceSample& face, Primitive& shape);
ARRISFILTERS_EXPORT bool GuessSphere(const FaceSample& face, Primitive& shape);
ARRISFILTERS_EXPORT bool GuessCylinder(const FaceSample& face, Primitive& shape);
ARRISFILTERS_EXPORT bool GuessCone(const FaceSample& face, Primitive& shape);
ARRISFILTERS_EXPORT bool GuessTorus(const FaceSample& face, Primitive& shape);
}

#endif
