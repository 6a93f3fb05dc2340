// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry.h"

#include "Parallel.h"

#include <algorithm>

namespace arris
{
namespace
{
double SquaredDistanceToSegment(const Vec3& point, const Vec3& a, const Vec3& b)
{
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - (a + t * along)).squaredNorm();
}
}

double Diagonal(const Mesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.Points)
  {
    box.extend(point);
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

double SquaredDistance(const Vec3& point, const Corners& triangle)
{
  const Vec3 normal = triangle.AreaVector();
  const double normal2 = normal.squaredNorm();
  const Vec3 fromA = point - triangle.A;
  // Inside the prism over the triangle the plane is nearest, elsewhere one of the three edges is.
  const bool inside = normal2 > 0.0 && (triangle.B - triangle.A).cross(fromA).dot(normal) >= 0.0 &&
    (triangle.C - triangle.B).cross(point - triangle.B).dot(normal) >= 0.0 &&
    (triangle.A - triangle.C).cross(point - triangle.C).dot(normal) >= 0.0;
  if (inside)
  {
    const double height = fromA.dot(normal);
    return height * height / normal2;
  }
  return std::min({ SquaredDistanceToSegment(point, triangle.A, triangle.B),
    SquaredDistanceToSegment(point, triangle.B, triangle.C),
    SquaredDistanceToSegment(point, triangle.C, triangle.A) });
}

std::vector<Vec3> UnitNormals(const Mesh& mesh, double averageEdgeLength)
{
  std::vector<Vec3> normals(mesh.Triangles.size());
  const double leastHeight = SliverHeight * averageEdgeLength;
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        normals[t] = UnitNormal(Corners(mesh, t), leastHeight);
      }
    });
  return normals;
}
}
