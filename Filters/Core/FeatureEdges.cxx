// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureEdges.h"

#include "Geometry.h"

#include <algorithm>

namespace arris
{
namespace
{
/// The corner where the triangle's edge between a and b starts.
int EdgeBetween(const Triangle& triangle, Index a, Index b)
{
  const int corner = CornerOf(triangle, a);
  return triangle[Next(corner)] == b ? corner : CornerOf(triangle, b);
}

/// The difference of the normals of two triangles on the edge from `a` to `b`, oriented alike.
double DifferenceAcross(
  const Mesh& mesh, const std::vector<Vec3>& normals, Index t, Index other, Index a, Index b)
{
  const bool alike = mesh.Triangles[t][EdgeBetween(mesh.Triangles[t], a, b)] !=
    mesh.Triangles[other][EdgeBetween(mesh.Triangles[other], a, b)];
  const Vec3 otherNormal = alike ? normals[other] : Vec3(-normals[other]);
  return normals[t].isZero(0.0) || normals[other].isZero(0.0)
    ? 0.0
    : 0.5 * (normals[t] - otherNormal).squaredNorm();
}

/// The triangles around edge k of `t`, when `t` is the lowest of them; empty otherwise.
void RingOfLowest(
  const Mesh& mesh, const Connectivity& connectivity, Index t, int k, std::vector<Index>& ring)
{
  const Index a = mesh.Triangles[t][k];
  const Index b = mesh.Triangles[t][Next(k)];
  ring.assign(1, t);
  for (Index next = connectivity.AcrossEdge[t][k]; next != NoIndex && next != t;
       next = connectivity.AcrossEdge[next][EdgeBetween(mesh.Triangles[next], a, b)])
  {
    if (next < t)
    {
      ring.clear();
      return;
    }
    ring.push_back(next);
  }
}

double LargestDifference(const Mesh& mesh, const std::vector<Vec3>& normals,
  const std::vector<Index>& ring, Index a, Index b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    for (std::size_t j = i + 1; j < ring.size(); ++j)
    {
      largest = std::max(largest, DifferenceAcross(mesh, normals, ring[i], ring[j], a, b));
    }
  }
  return largest;
}
}

std::vector<FeatureEdge> FindFeatureEdges(
  const Mesh& mesh, const Connectivity& connectivity, double featureAngle, const Monitor& monitor)
{
  const std::vector<Vec3> normals = UnitNormals(mesh, 0.0);
  const double threshold = DifferenceOfAngle(featureAngle);

  // The angle at each edge of each triangle first, in parallel; negative for no feature. Then the
  // list in order.
  std::vector<std::array<float, 3>> found(mesh.Triangles.size());
  const bool finished = ParallelFor(mesh.TriangleCount(), monitor,
    [&](Index begin, Index end)
    {
      std::vector<Index> ring;
      for (Index t = begin; t < end; ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Triangle& triangle = mesh.Triangles[t];
          RingOfLowest(mesh, connectivity, t, k, ring);
          const double difference = ring.size() < 2
            ? -1.0
            : LargestDifference(mesh, normals, ring, triangle[k], triangle[Next(k)]);
          const bool feature = ring.size() > 2 || difference > threshold;
          found[t][k] = feature ? static_cast<float>(AngleOfDifference(difference)) : -1.0f;
        }
      }
    });

  std::vector<FeatureEdge> edges;
  if (finished)
  {
    for (Index t = 0; t < mesh.TriangleCount(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (found[t][k] >= 0.0f)
        {
          const auto ends = std::minmax(mesh.Triangles[t][k], mesh.Triangles[t][Next(k)]);
          edges.push_back({ ends.first, ends.second, found[t][k] });
        }
      }
    }
    std::sort(edges.begin(), edges.end(),
      [](const FeatureEdge& a, const FeatureEdge& b)
      { return a.A != b.A ? a.A < b.A : a.B < b.B; });
  }
  return edges;
}

const FeatureEdge* FindFeature(const std::vector<FeatureEdge>& sortedFeatures, Index a, Index b)
{
  const auto ends = std::minmax(a, b);
  const auto found = std::lower_bound(sortedFeatures.begin(), sortedFeatures.end(), ends,
    [](const FeatureEdge& edge, const std::pair<Index, Index>& key)
    { return edge.A != key.first ? edge.A < key.first : edge.B < key.second; });
  return found != sortedFeatures.end() && found->A == ends.first && found->B == ends.second
    ? &*found
    : nullptr;
}
}
