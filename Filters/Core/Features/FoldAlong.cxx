// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FoldAlong.h"

#include "Core/Geometry.h"
#include "Core/IndexSet.h"

#include <algorithm>
#include <array>

namespace arris
{
namespace
{
/// On a cylinder the sides differ by twice as much as their halves do.
constexpr double Concentration = 4.0;

/// The triangles around a way, connected with it but not across a feature, with their centroids no
/// farther from its middle than it is long.
std::vector<Index> TrianglesAround(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& features, const std::vector<Index>& way)
{
  const Vec3 middle = 0.5 * (mesh.Points[way.front()] + mesh.Points[way.back()]);
  const double reach = (mesh.Points[way.back()] - mesh.Points[way.front()]).norm();
  IndexSet seen;
  std::vector<Index> found;
  const auto add = [&](Index t)
  {
    if (seen.Insert(t) && (Corners(mesh, t).Centroid() - middle).norm() <= reach)
    {
      found.push_back(t);
    }
  };
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
  {
    for (const Index t : connectivity.TrianglesOfVertex[way[i]])
    {
      const Triangle& triangle = mesh.Triangles[t];
      if (std::find(triangle.begin(), triangle.end(), way[i + 1]) != triangle.end())
      {
        add(t);
      }
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const Index t = found[i];
    for (int k = 0; k < 3; ++k)
    {
      const Triangle& triangle = mesh.Triangles[t];
      const Index next = connectivity.AcrossEdge[t][k];
      if (next != NoIndex && !FindFeature(features, triangle[k], triangle[Next(k)]))
      {
        add(next);
      }
    }
  }
  return found;
}
}

bool FoldsAlong(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& sortedFeatures, const std::vector<Index>& way, double angle)
{
  const Vec3 middle = 0.5 * (mesh.Points[way.front()] + mesh.Points[way.back()]);
  const Vec3 along = mesh.Points[way.back()] - mesh.Points[way.front()];
  const std::vector<Index> around = TrianglesAround(mesh, connectivity, sortedFeatures, way);
  Vec3 normal = Vec3::Zero();
  for (const Index t : around)
  {
    normal += Corners(mesh, t).AreaVector();
  }
  const Vec3 aside = DirectionOf(normal.cross(along));
  std::array<std::array<Vec3, 2>, 2> halves; // by side, then near and far
  halves.fill({ Vec3::Zero(), Vec3::Zero() });
  for (const Index t : around)
  {
    const Corners corners(mesh, t);
    const double offset = aside.dot(corners.Centroid() - middle);
    halves[offset > 0.0 ? 1 : 0][std::abs(offset) > 0.5 * along.norm() ? 1 : 0] +=
      corners.AreaVector();
  }
  const auto between = [](const Vec3& a, const Vec3& b)
  {
    return a.isZero(0.0) || b.isZero(0.0)
      ? 0.0
      : AngleOfDifference(0.5 * (a.normalized() - b.normalized()).squaredNorm());
  };
  const double fold = between(halves[0][0] + halves[0][1], halves[1][0] + halves[1][1]);
  const double bend =
    std::max(between(halves[0][0], halves[0][1]), between(halves[1][0], halves[1][1]));
  return fold > angle && fold > Concentration * bend;
}
}
