// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Creases.h"

#include "Core/Geometry.h"

#include <cmath>

namespace arris
{
namespace
{
Vec3 AreaVector(
  const std::vector<Triangle>& triangles, const std::vector<Vec3>& points, Index triangle)
{
  return Corners(points, triangles[triangle]).AreaVector();
}

double Crease(const Vec3& edge, const Vec3& left, const Vec3& right)
{
  return edge.norm() * std::sqrt(std::atan2(left.cross(right).norm(), left.dot(right)));
}
}

double CreasesAround(const std::vector<Triangle>& triangles, const Connectivity& connectivity,
  const std::vector<Vec3>& points, Index vertex, double enough)
{
  double sum = 0.0;
  for (Index t : connectivity.TrianglesOfVertex[vertex])
  {
    if (sum >= enough)
    {
      break;
    }
    const int k = CornerOf(triangles[t], vertex);
    const Vec3 normal = AreaVector(triangles, points, t);
    // Of the two edges at the vertex one is left to the next triangle.
    for (const int edge : { k, Next(k) })
    {
      const Index across = connectivity.AcrossEdge[t][edge];
      if (across != NoIndex)
      {
        const Vec3 way = points[triangles[t][Next(edge)]] - points[triangles[t][edge]];
        sum += Crease(way, normal, AreaVector(triangles, points, across));
      }
    }
  }
  return sum;
}
}
