// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Overturned.h"

#include "Core/Geometry.h"

#include <algorithm>

namespace arris
{
namespace
{
/// Of the cosine between the normals of two triangles that lie on each other, to 10 degrees.
constexpr double FoldedSquare = 0.969846310;

/// Whether triangles with these area vectors lie on each other, if they have an edge in common.
bool AreFolded(const Vec3& a, const Vec3& b)
{
  const double dot = a.dot(b);
  return dot < 0.0 && dot * dot > FoldedSquare * a.squaredNorm() * b.squaredNorm();
}

/// Whether the triangle faces against all that share a vertex with it, itself included.
bool FacesAgainstAll(
  const Mesh& mesh, const Connectivity& connectivity, const Vec3& area, Index triangle)
{
  const auto isAgainst = [&](Index t) { return area.dot(Corners(mesh, t).AreaVector()) < 0.0; };
  const Triangle& corners = mesh.Triangles[triangle];
  return isAgainst(triangle) &&
    std::all_of(corners.begin(), corners.end(),
      [&](Index v)
      {
        const IndexSpan around = connectivity.TrianglesOfVertex[v];
        return std::all_of(around.begin(), around.end(), isAgainst);
      });
}
}

bool IsOverturned(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Vec3>& points, Index triangle)
{
  const Vec3 area = Corners(points, mesh.Triangles[triangle]).AreaVector();
  for (Index beyond : connectivity.AcrossEdge[triangle])
  {
    if (beyond != NoIndex &&
      AreFolded(area, Corners(points, mesh.Triangles[beyond]).AreaVector()) &&
      AreOnePatch(connectivity, triangle, beyond) && // patches face as they please
      !AreFolded(Corners(mesh, triangle).AreaVector(), Corners(mesh, beyond).AreaVector()))
    {
      return true;
    }
  }
  return FacesAgainstAll(mesh, connectivity, area, triangle);
}
}
