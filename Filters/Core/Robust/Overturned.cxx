// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Overturned.h"

#include "Core/Geometry.h"

#include <algorithm>

namespace arris
{
bool MayFold(const Mesh& mesh, const Connectivity& connectivity, Index triangle, Index beyond)
{
  return AreOnePatch(connectivity, triangle, beyond) && // patches face as they please
    !AreFolded(Corners(mesh, triangle).AreaVector(), Corners(mesh, beyond).AreaVector());
}

bool FacesAgainstAll(
  const Mesh& mesh, const Connectivity& connectivity, const Vec3& area, Index triangle, Vec3& other)
{
  const auto isAgainst = [&](Index t)
  {
    other = Corners(mesh, t).AreaVector();
    return area.dot(other) < 0.0;
  };
  const Triangle& corners = mesh.Triangles[triangle];
  return isAgainst(triangle) &&
    std::all_of(corners.begin(), corners.end(),
      [&](Index v)
      {
        const IndexSpan around = connectivity.TrianglesOfVertex[v];
        return std::all_of(around.begin(), around.end(), isAgainst);
      });
}

bool IsOverturned(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Vec3>& points, Index triangle)
{
  const Vec3 area = Corners(points, mesh.Triangles[triangle]).AreaVector();
  for (Index beyond : connectivity.AcrossEdge[triangle])
  {
    if (beyond != NoIndex &&
      AreFolded(area, Corners(points, mesh.Triangles[beyond]).AreaVector()) &&
      MayFold(mesh, connectivity, triangle, beyond))
    {
      return true;
    }
  }
  Vec3 other;
  return FacesAgainstAll(mesh, connectivity, area, triangle, other);
}
}
