// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleCrossing.h"

#include "Geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris
{
namespace
{
/// What is this small a part of the longest edge is a touch (and as an angle, in radians, flat).
constexpr double TouchTolerance = 1e-10;

/// What a determinant may be off by, in roundings of its largest term: its own, and those that the
/// four points went through when they were computed. Generous by about a factor of two.
constexpr double RoundingSteps = 16.0;

/// A triangle laid out for the tests.
struct Face
{
  std::array<Vec3, 3> Points;
  Vec3 Normal; ///< twice the area long

  Face(const MeshView& mesh, const Triangle& triangle)
    : Points{ mesh.Points[triangle[0]], mesh.Points[triangle[1]], mesh.Points[triangle[2]] }
    , Normal((this->Points[1] - this->Points[0]).cross(this->Points[2] - this->Points[0]))
  {
  }

  double TwiceArea() const { return this->Normal.norm(); }
  double LongestEdge() const
  {
    return std::sqrt(std::max({ (this->Points[1] - this->Points[0]).squaredNorm(),
      (this->Points[2] - this->Points[1]).squaredNorm(),
      (this->Points[0] - this->Points[2]).squaredNorm() }));
  }

  /// Twice the area times the height of a point over the plane; 0 without rounding for the first
  /// corner.
  double Volume(const Vec3& point) const { return this->Normal.dot(point - this->Points[0]); }
};

/// On which side of a plane each corner is: 1, -1, or 0 for in it.
using Sides = std::array<int, 3>;

/// What counts as zero between two triangles.
class Margin
{
public:
  Margin(const Face& one, const Face& other)
  {
    const double longest1 = one.LongestEdge();
    const double longest2 = other.LongestEdge();
    this->Size = std::max(longest1, longest2);
    this->Smaller = std::min(longest1, longest2);
    this->Rounding = RoundingSteps * std::numeric_limits<double>::epsilon() *
      (one.Points[0].cwiseAbs().maxCoeff() + this->Size);
  }

  bool HasArea(const Face& face) const
  {
    const double longest = face.LongestEdge();
    return face.TwiceArea() > (TouchTolerance * longest + this->Rounding) * longest;
  }

  /// On which sides of a plane the corners of a triangle are.
  Sides SidesOf(const Face& face, const Face& plane) const
  {
    const double area = plane.TwiceArea();
    const double longest = plane.LongestEdge();
    Sides sides;
    for (int k = 0; k < 3; ++k)
    {
      sides[k] = this->Sign(plane.Volume(face.Points[k]), area, longest);
    }
    return sides;
  }

  /// On which side an edge, made longer as needed, passes another one.
  int Passing(const Vec3& from1, const Vec3& to1, const Vec3& from2, const Vec3& to2) const
  {
    const Vec3 across = (to1 - from1).cross(to2 - from2);
    return this->Sign(across.dot(from2 - from1), across.norm(), this->Smaller);
  }

  /// Up to which sine two faces are in one plane, if they have an edge in common and their third
  /// corners are `height1` and `height2` away from it.
  double Flat(double height1, double height2) const
  {
    return TouchTolerance + this->Rounding * (1.0 / height1 + 1.0 / height2);
  }

private:
  /// The sign of the distance that a volume is the `area` times. A point that moves changes the
  /// volume by as much as the side opposite to it is wide: at most Size one way, and `width` the
  /// other.
  int Sign(double volume, double area, double width) const
  {
    const double zero = (TouchTolerance * area + this->Rounding * width) * this->Size;
    return volume > zero ? 1 : (volume < -zero ? -1 : 0);
  }

  double Size;
  double Smaller;
  double Rounding; ///< of a coordinate
};

bool OnBothSides(const Sides& sides)
{
  return std::min({ sides[0], sides[1], sides[2] }) < 0 &&
    std::max({ sides[0], sides[1], sides[2] }) > 0;
}

/// The corner that has a side of the plane to itself, given that there are some on both.
int LoneCorner(const Sides& sides)
{
  for (int k = 0; k < 2; ++k)
  {
    if (sides[k] != 0 && sides[k] != sides[Next(k)] && sides[k] != sides[Next(Next(k))])
    {
      return k;
    }
  }
  return 2;
}

/// Whether the plane of a triangle leaves another one on one side, to the last bit: most pairs are
/// done with it, before anything is known about the margin.
bool OnOneSide(const Face& face, const Face& plane)
{
  const double volume0 = plane.Volume(face.Points[0]);
  const double volume1 = plane.Volume(face.Points[1]);
  const double volume2 = plane.Volume(face.Points[2]);
  return std::min({ volume0, volume1, volume2 }) >= 0.0 ||
    std::max({ volume0, volume1, volume2 }) <= 0.0;
}

/// Whether two triangles that share no vertex, or the first one of each, have inner points in
/// common.
///
/// They can only have them on the line where their planes meet, which goes through a triangle
/// that is on both sides of the other plane along a segment: from edge pq to edge pr, if p is its
/// lone corner; and likewise from ab to ac. Looking so that p is above plane abc and a above plane
/// pqr, the first segment runs from pq to pr and the second one from ac to ab (the line taken along
/// n_abc x n_pqr, n being normals). So they overlap if pq comes before ab, and ac before pr. Of two
/// edges that go down through the line, pq comes before ab if the determinant |q - p, b - a, a - p|
/// is positive: with the one crossing at x and the other at x + t n_abc x n_pqr, it is
/// t (n_abc.(q - p)) (n_pqr.(b - a)), and both factors are negative.
///
/// A shared vertex is in both planes and so an end of both segments. Where the edges to it are
/// those compared, the determinant vanishes: the segments leave the vertex to different sides.
bool Cross(const Face& one, const Face& other, const Margin& margin)
{
  const Sides sides1 = margin.SidesOf(one, other);
  const Sides sides2 = margin.SidesOf(other, one);
  if (!OnBothSides(sides1) || !OnBothSides(sides2))
  {
    return false;
  }
  const int lone1 = LoneCorner(sides1);
  const int lone2 = LoneCorner(sides2);
  int q = Next(lone1);
  int r = Next(q);
  int b = Next(lone2);
  int c = Next(b);
  if (sides2[lone2] < 0) // turn the plane of `one` over
  {
    std::swap(q, r);
  }
  if (sides1[lone1] < 0)
  {
    std::swap(b, c);
  }
  const Vec3& p = one.Points[lone1];
  const Vec3& a = other.Points[lone2];
  return margin.Passing(p, one.Points[q], a, other.Points[b]) > 0 &&
    margin.Passing(p, one.Points[r], a, other.Points[c]) < 0;
}

/// Whether two triangles whose first two corners are the same lie on each other.
bool Folded(const Face& one, const Face& other, const Margin& margin)
{
  const double edge = (one.Points[1] - one.Points[0]).norm();
  const double area1 = one.TwiceArea();
  const double area2 = other.TwiceArea();
  return one.Normal.dot(other.Normal) > 0.0 &&
    one.Normal.cross(other.Normal).norm() <=
    area1 * area2 * margin.Flat(area1 / edge, area2 / edge);
}

/// Brings the vertices that two triangles share to the front, in the same order; how many.
int ShareFirst(Triangle& one, Triangle& other)
{
  int count = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = count; j < 3; ++j)
    {
      if (one[i] == other[j])
      {
        std::swap(one[i], one[count]);
        std::swap(other[j], other[count]);
        ++count;
        break;
      }
    }
  }
  return count;
}
}

bool CutThrough(const MeshView& mesh, Index t1, Index t2)
{
  Triangle triangle1 = mesh.Triangles[t1];
  Triangle triangle2 = mesh.Triangles[t2];
  const bool shareEdge = ShareFirst(triangle1, triangle2) >= 2;
  const Face one(mesh, triangle1);
  const Face other(mesh, triangle2);
  const bool surelyNot = shareEdge ? one.Normal.dot(other.Normal) <= 0.0
                                   : OnOneSide(one, other) || OnOneSide(other, one);
  if (surelyNot)
  {
    return false;
  }
  const Margin margin(one, other);
  return margin.HasArea(one) && margin.HasArea(other) &&
    (shareEdge ? Folded(one, other, margin) : Cross(one, other, margin));
}
}
