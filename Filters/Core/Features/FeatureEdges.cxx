// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureEdges.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace arris
{
FeatureEdge MakeFeature(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t, int k)
{
  const Triangle& triangle = mesh.Triangles[t];
  const auto ends = std::minmax(triangle[k], triangle[Next(k)]);
  const EdgeFold fold = FoldAt(mesh, connectivity, folds, t, k);
  FeatureEdge edge{ ends.first, ends.second,
    std::min(180.0, AngleOfDifference(std::abs(static_cast<double>(fold.Difference)))), fold.Kind,
    t, connectivity.AcrossEdge[t][k] };
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
  ParallelFor(static_cast<Index>(folds.Steep.size()),
    [&](Index begin, Index end)
    {
      std::vector<FeatureEdge> found;
      for (Index i = begin; i < end; ++i)
      {
        const SteepEdge& steep = folds.Steep[i];
        const Index t = steep.Triangle;
        const int k = steep.Edge;
        if (steep.Difference > threshold || !IsFold(FoldAt(mesh, connectivity, folds, t, k).Kind))
        {
          found.push_back(MakeFeature(mesh, connectivity, folds, t, k));
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
  std::sort(edges.begin(), edges.end(), ComesBefore);
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
