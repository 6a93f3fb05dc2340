// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Hysteresis.h"

#include "Core/EdgeGraph.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace arris
{
namespace
{
/// Candidates as a graph, some of them chosen.
class Chooser
{
public:
  Chooser(const std::vector<FeatureEdge>& candidates, const std::vector<double>& angles,
    const std::vector<Vec3>& points, const AngleBand& band)
    : Candidates(candidates)
    , Angles(angles)
    , Points(points)
    , Band(band)
    , Graph(EndsOf(candidates))
    , Chosen(candidates.size(), 0)
    , ChosenAt(this->Graph.size(), 0)
  {
  }

  void Choose(std::size_t edge)
  {
    this->Chosen[edge] = 1;
    ++this->ChosenAt[this->Graph.NodeOf(this->Candidates[edge].A)];
    ++this->ChosenAt[this->Graph.NodeOf(this->Candidates[edge].B)];
  }

  /// Chooses edges but for those between two vertices that chosen ones go through already: near a
  /// corner these lead across from one feature to another.
  void ChooseWhereNeeded(std::vector<std::size_t> edges)
  {
    const auto isPassed = [&](Index vertex)
    { return this->ChosenAt[this->Graph.NodeOf(vertex)] >= 2; };
    edges.erase(std::remove_if(edges.begin(), edges.end(),
                  [&](std::size_t edge) {
                    return isPassed(this->Candidates[edge].A) && isPassed(this->Candidates[edge].B);
                  }),
      edges.end());
    for (const std::size_t edge : edges)
    {
      this->Choose(edge);
    }
  }

  /// Carries all free ends on by an edge at a time, so that none is before the others.
  void ContinueFromEnds()
  {
    std::vector<Index> ends(this->Graph.size());
    std::iota(ends.begin(), ends.end(), 0);
    while (!ends.empty())
    {
      std::vector<std::array<Index, 2>> steps; // edge, where it leads
      for (const Index end : ends)
      {
        const int i = this->ChosenAt[end] == 1 ? this->GoesOn(end) : -1;
        if (i >= 0)
        {
          steps.push_back({ this->Graph.Edge(end, i), this->Graph.Neighbor(end, i) });
        }
      }
      ends.clear();
      for (const auto& [edge, node] : steps)
      {
        if (!this->Chosen[edge]) // by an end that came from the other side
        {
          this->Choose(static_cast<std::size_t>(edge));
          ends.push_back(node);
        }
      }
    }
  }

  std::vector<FeatureEdge> Result() const
  {
    std::vector<FeatureEdge> chosen;
    for (std::size_t i = 0; i < this->Candidates.size(); ++i)
    {
      if (this->Chosen[i])
      {
        chosen.push_back(this->Candidates[i]);
      }
    }
    return chosen;
  }

private:
  const Vec3& At(Index node) const { return this->Points[this->Graph.MeshVertex(node)]; }

  /// Which of its edges goes on at a free end; -1 if none does.
  int GoesOn(Index end) const
  {
    int last = 0;
    while (!this->Chosen[this->Graph.Edge(end, last)])
    {
      ++last;
    }
    const EdgeKind kind = this->Candidates[this->Graph.Edge(end, last)].Kind;
    const Vec3 in = (this->At(end) - this->At(this->Graph.Neighbor(end, last))).normalized();
    const double leastCosine = std::cos(this->Band.Turn * Pi / 180.0);
    int best = -1;
    for (int i = 0; i < this->Graph.Valence(end); ++i)
    {
      const Index edge = this->Graph.Edge(end, i);
      const Vec3 out = (this->At(this->Graph.Neighbor(end, i)) - this->At(end)).normalized();
      const bool goesOn = !this->Chosen[edge] && IsFold(kind) &&
        this->Candidates[edge].Kind == kind && this->Angles[edge] > this->Band.Continuation &&
        this->Candidates[edge].DihedralAngle <= this->Band.Largest && in.dot(out) >= leastCosine;
      if (goesOn && (best < 0 || this->Angles[edge] > this->Angles[this->Graph.Edge(end, best)]))
      {
        best = i;
      }
    }
    return best;
  }

  const std::vector<FeatureEdge>& Candidates;
  const std::vector<double>& Angles;
  const std::vector<Vec3>& Points;
  const AngleBand& Band;
  const EdgeGraph Graph;
  Flags Chosen; // candidates
  std::vector<int> ChosenAt; // how many at each node
};
}

std::vector<FeatureEdge> ChooseEdges(const std::vector<FeatureEdge>& candidates,
  const std::vector<double>& angles, const std::vector<Vec3>& points, const AngleBand& band,
  bool boundary, bool nonManifold, const Flags& likely)
{
  Chooser chooser(candidates, angles, points, band);
  std::vector<std::size_t> expected; // where features are, but below the upper angle
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const FeatureEdge& edge = candidates[i];
    const bool isFold = IsFold(edge.Kind) && edge.DihedralAngle <= band.Largest;
    if (edge.Kind == EdgeKind::Boundary      ? boundary
        : edge.Kind == EdgeKind::NonManifold ? nonManifold
                                             : isFold && angles[i] > band.Seed)
    {
      chooser.Choose(i);
    }
    else if (isFold && !likely.empty() && likely[edge.A] && likely[edge.B] &&
      angles[i] > band.Continuation)
    {
      expected.push_back(i);
    }
  }
  chooser.ChooseWhereNeeded(expected);
  chooser.ContinueFromEnds();
  return chooser.Result();
}
}
