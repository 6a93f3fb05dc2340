// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Creases.h"

#include "Core/Geometry.h"

#include <cmath>

namespace arris
{
namespace
{
/// Points of which one is elsewhere.
class PointsWithOneAt
{
public:
  PointsWithOneAt(const std::vector<Vec3>& points, Index vertex, const Vec3& at)
    : Points(points)
    , Vertex(vertex)
    , At(at)
  {
  }

  const Vec3& operator[](Index v) const { return v == this->Vertex ? this->At : this->Points[v]; }

  Vec3 AreaVector(const Triangle& corners) const
  {
    return Corners((*this)[corners[0]], (*this)[corners[1]], (*this)[corners[2]]).AreaVector();
  }

private:
  const std::vector<Vec3>& Points;
  Index Vertex;
  const Vec3& At;
};

double Crease(const Vec3& edge, const Vec3& left, const Vec3& right)
{
  return edge.norm() * std::sqrt(std::atan2(left.cross(right).norm(), left.dot(right)));
}
}

double CreasesAround(const std::vector<Triangle>& triangles, const Connectivity& connectivity,
  const std::vector<Vec3>& points, Index vertex, const Vec3& at, double enough)
{
  const PointsWithOneAt moved(points, vertex, at);
  double sum = 0.0;
  for (Index t : connectivity.TrianglesOfVertex[vertex])
  {
    if (sum >= enough)
    {
      break;
    }
    const int k = CornerOf(triangles[t], vertex);
    const Vec3 normal = moved.AreaVector(triangles[t]);
    // Of the two edges at the vertex one is left to the next triangle.
    for (const int edge : { k, Next(k) })
    {
      const Index across = connectivity.AcrossEdge[t][edge];
      if (across != NoIndex)
      {
        const Vec3 way = moved[triangles[t][Next(edge)]] - moved[triangles[t][edge]];
        sum += Crease(way, normal, moved.AreaVector(triangles[across]));
      }
    }
  }
  return sum;
}
}
