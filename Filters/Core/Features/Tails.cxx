// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Tails.h"

#include "Core/Curves.h"

#include <algorithm>

namespace arris
{
namespace
{
/// Whether a curve of the network ends where no other one goes on.
class FreeEnds
{
public:
  FreeEnds(const CurveNetwork& network, const Flags& onBoundary)
  {
    for (const CurveCorner& corner : network.Corners)
    {
      if (corner.Valence == 1 && !onBoundary[corner.Vertex])
      {
        this->Vertices.push_back(corner.Vertex); // ascending
      }
    }
  }
  bool Has(const Curve& curve) const
  {
    return std::binary_search(this->Vertices.begin(), this->Vertices.end(), curve.front()) ||
      std::binary_search(this->Vertices.begin(), this->Vertices.end(), curve.back());
  }

private:
  std::vector<Index> Vertices;
};

/// Whether features are expected at half of a curve's edges or more.
bool IsLikely(const Curve& curve, const Flags& likely)
{
  if (likely.empty())
  {
    return true;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
  {
    count += likely[curve[i]] && likely[curve[i + 1]] ? 1 : 0;
  }
  return 2 * count >= curve.size() - 1;
}

/// Drops the folds of the curves that a test says; whether there were any.
template <typename IsDropped>
bool Drop(const CurveNetwork& network, IsDropped&& isDropped, std::vector<FeatureEdge>& edges)
{
  Flags dropped(edges.size(), 0);
  bool any = false;
  for (const Curve& curve : network.Curves)
  {
    if (!isDropped(curve))
    {
      continue;
    }
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
    {
      const FeatureEdge* edge = FindFeature(edges, curve[i], curve[i + 1]);
      if (IsFold(edge->Kind))
      {
        dropped[edge - edges.data()] = 1;
        any = true;
      }
    }
  }
  if (any)
  {
    std::vector<FeatureEdge> kept;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (!dropped[i])
      {
        kept.push_back(edges[i]);
      }
    }
    edges = std::move(kept);
  }
  return any;
}
}

void CutTails(const std::vector<Vec3>& points, const Flags& onBoundary,
  const FeatureCriteria& criteria, std::vector<FeatureEdge>& edges)
{
  // Each round drops an edge or is the last, and what a round leaves is joined anew: where a tail
  // is gone, two curves are one, which may be long enough.
  const double unlikely = std::max(criteria.TailLength, criteria.UnlikelyLength);
  bool again = criteria.TailLength > 0.0;
  while (again)
  {
    const CurveNetwork network =
      JoinEdges(EndsOf(edges), points, { criteria.Band.Turn, criteria.CornerReach, {}, true });
    const FreeEnds ends(network, onBoundary);
    again = Drop(
      network,
      [&](const Curve& curve)
      {
        return ends.Has(curve) &&
          LengthOf(curve, points) <
          (IsLikely(curve, criteria.Likely) ? criteria.TailLength : unlikely);
      },
      edges);
  }
  again = criteria.MinimumLength > 0.0;
  while (again)
  {
    const CurveNetwork network = JoinEdges(EndsOf(edges), points);
    again = Drop(
      network, [&](const Curve& curve) { return LengthOf(curve, points) < criteria.MinimumLength; },
      edges);
  }
}
}
