// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureEdges.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace arris
{
namespace
{
/// Whether no other triangle at this edge has a lower number: so that each edge is named once.
bool IsLowestAt(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t,
  int k, std::vector<Index>& ring)
{
  if (folds.Kinds[t][k] != EdgeKind::NonManifold)
  {
    const Index other = connectivity.AcrossEdge[t][k];
    return other == NoIndex || t < other;
  }
  RingOfEdge(mesh, connectivity, t, k, ring);
  return *std::min_element(ring.begin(), ring.end()) == t;
}
}

FeatureEdge MakeFeature(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t, int k)
{
  const Triangle& triangle = mesh.Triangles[t];
  const auto ends = std::minmax(triangle[k], triangle[Next(k)]);
  FeatureEdge edge{ ends.first, ends.second,
    std::min(180.0, AngleOfDifference(std::abs(static_cast<double>(folds.Differences[t][k])))),
    folds.Kinds[t][k], t, connectivity.AcrossEdge[t][k] };
  if (triangle[k] != edge.A)
  {
    std::swap(edge.Left, edge.Right);
  }
  return edge;
}

FeatureEdge MakeFeatureBetween(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index a, Index b)
{
  for (Index t : connectivity.TrianglesOfVertex[a])
  {
    const Triangle& triangle = mesh.Triangles[t];
    if (triangle[0] == b || triangle[1] == b || triangle[2] == b)
    {
      return MakeFeature(mesh, connectivity, folds, t, EdgeBetween(triangle, a, b));
    }
  }
  return { std::min(a, b), std::max(a, b), 0.0, EdgeKind::Boundary, NoIndex, NoIndex };
}

std::vector<FeatureEdge> CandidateEdges(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, double least)
{
  const double threshold = DifferenceOfAngle(least);
  std::vector<FeatureEdge> edges;
  std::mutex adding;
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      std::vector<FeatureEdge> found;
      std::vector<Index> ring;
      for (Index t = begin; t < end; ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          const bool candidate = !IsFold(folds.Kinds[t][k]) ||
            std::abs(static_cast<double>(folds.Differences[t][k])) > threshold;
          if (candidate && IsLowestAt(mesh, connectivity, folds, t, k, ring))
          {
            found.push_back(MakeFeature(mesh, connectivity, folds, t, k));
          }
        }
      }
      const std::lock_guard<std::mutex> lock(adding);
      edges.insert(edges.end(), found.begin(), found.end());
    });
  SortEdges(edges); // whoever came first
  return edges;
}

void SortEdges(std::vector<FeatureEdge>& edges)
{
  std::sort(edges.begin(), edges.end(),
    [](const FeatureEdge& a, const FeatureEdge& b) { return a.A != b.A ? a.A < b.A : a.B < b.B; });
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

std::vector<std::array<Index, 2>> EndsOf(const std::vector<FeatureEdge>& edges)
{
  std::vector<std::array<Index, 2>> ends;
  ends.reserve(edges.size());
  for (const FeatureEdge& edge : edges)
  {
    ends.push_back({ edge.A, edge.B });
  }
  return ends;
}
}
