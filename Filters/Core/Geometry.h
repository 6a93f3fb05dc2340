// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Geometry.h
/// Closed-form geometry of single triangles, and of angles as the paper writes them.

#ifndef arris_Geometry_h
#define arris_Geometry_h

#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace arris
{
constexpr double Pi = 3.14159265358979323846;

/// The three corner positions of a triangle.
struct Corners
{
  Vec3 A, B, C;

  Corners(const std::vector<Vec3>& points, const Triangle& triangle)
    : A(points[triangle[0]])
    , B(points[triangle[1]])
    , C(points[triangle[2]])
  {
  }
  Corners(const Mesh& mesh, Index triangle)
    : Corners(mesh.Points, mesh.Triangles[triangle])
  {
  }
  Corners(const Vec3& a, const Vec3& b, const Vec3& c)
    : A(a)
    , B(b)
    , C(c)
  {
  }

  /// Normal to the triangle, twice its area long.
  Vec3 AreaVector() const { return (this->B - this->A).cross(this->C - this->A); }
  Vec3 Centroid() const { return (this->A + this->B + this->C) / 3.0; }
};

/// The normals of the triangles around a vertex, twice their areas long, added up.
inline Vec3 AreaVectorAround(const std::vector<Triangle>& triangles,
  const std::vector<Vec3>& points, const Connectivity& connectivity, Index vertex)
{
  Vec3 sum = Vec3::Zero();
  for (Index t : connectivity.TrianglesOfVertex[vertex])
  {
    sum += Corners(points, triangles[t]).AreaVector();
  }
  return sum;
}
inline Vec3 AreaVectorAround(const Mesh& mesh, const Connectivity& connectivity, Index vertex)
{
  return AreaVectorAround(mesh.Triangles, mesh.Points, connectivity, vertex);
}

/// The direction of a vector; zero if it has none.
inline Vec3 DirectionOf(const Vec3& vector)
{
  const double length = vector.norm();
  return length > 0.0 ? Vec3(vector / length) : Vec3(Vec3::Zero());
}

/// The diagonal of the box around all points; 0 if there are none.
ARRISFILTERS_EXPORT double Diagonal(const Mesh& mesh);

/// The square of the distance from a point to a triangle: to the point set, not to the plane.
ARRISFILTERS_EXPORT double SquaredDistance(const Vec3& point, const Corners& triangle);

/// The unit normal of a triangle; zero if its height is no more than that.
inline Vec3 UnitNormal(const Vec3& a, const Vec3& b, const Vec3& c, double height)
{
  const Vec3 toB = b - a;
  const Vec3 toC = c - a;
  const Vec3 area = toB.cross(toC);
  const double square = area.squaredNorm();
  const double longest = std::max({ toB.squaredNorm(), (c - b).squaredNorm(), toC.squaredNorm() });
  const double twiceArea = std::sqrt(square);
  // Nearly all triangles are so much higher that it needs no second root.
  const bool high =
    square > 4.0 * height * height * longest || twiceArea > height * std::sqrt(longest);
  return high ? Vec3(area / twiceArea) : Vec3(Vec3::Zero());
}
inline Vec3 UnitNormal(const Corners& corners, double height)
{
  return UnitNormal(corners.A, corners.B, corners.C, height);
}

/// The unit normal of each triangle; zero where a triangle is so flat (its height under
/// `SliverHeight` of its mesh's average edge length) that rounding decides where it looks.
ARRISFILTERS_EXPORT std::vector<Vec3> UnitNormals(const Mesh& mesh, double averageEdgeLength);

/// The least height of a triangle whose normal is believed, as a part of the average edge length.
/// Contours are full of slivers that are exact but for the rounding of their single-precision
/// points (about 1e-6 of an edge): at a thousandth of an edge that rounding turns them by 0.1°.
constexpr double SliverHeight = 1e-3;

/// The paper's second-order difference 1 - n1.n2 of an angle between two normals, and back;
/// degrees. For unit normals the difference is half the square of the chord between them.
inline double DifferenceOfAngle(double degrees)
{
  const double half = std::sin(0.5 * degrees * Pi / 180.0);
  return 2.0 * half * half; // 1 - cos, without its cancellation
}
inline double AngleOfDifference(double difference)
{
  return 2.0 * std::asin(std::sqrt(std::min(1.0, 0.5 * difference))) * 180.0 / Pi;
}
}

#endif
