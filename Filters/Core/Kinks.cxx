// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Kinks.h"

#include "Geometry.h"

#include <algorithm>

namespace arris
{
namespace
{
/// A vertex that stands off takes two edges, one that is doubled as well a third.
constexpr std::size_t MostEdges = 3;

/// The edge next to a turn leads to or from the vertex that stands off; so many after it tell where
/// the curve goes.
constexpr std::size_t Apart = 1;
constexpr std::size_t Stretch = 3;

class Straightener
{
public:
  Straightener(const EdgeGraph& graph, const std::vector<Vec3>& points, const Flags& junctions,
    double angle, const Flags& turns)
    : Graph(graph)
    , Points(points)
    , Junctions(junctions)
    , Angle(angle)
    , Turns(turns)
  {
  }

  /// The kink that `node`, a turn, is one end of; empty if it is none.
  std::vector<Index> KinkFrom(Index node) const
  {
    for (const int way : { 0, 1 })
    {
      const std::vector<Index> ahead = this->Walk(node, way, MostEdges + Apart + Stretch);
      std::size_t last = 0; // the farthest turn within reach
      for (std::size_t i = 1; i < ahead.size() && i <= MostEdges; ++i)
      {
        last = this->Turns[ahead[i]] ? i : last;
      }
      const std::vector<Index> beyond(ahead.begin() + last, ahead.end());
      if (this->GoesOn(this->Walk(node, 1 - way, Apart + Stretch), beyond))
      {
        return { ahead.begin(), ahead.begin() + last + 1 };
      }
    }
    return {};
  }

private:
  /// The nodes from `start` on, at most so many edges of them: up to a junction, or to `start`.
  std::vector<Index> Walk(Index start, int way, std::size_t edges) const
  {
    std::vector<Index> nodes = { start, this->Graph.Neighbor(start, way) };
    while (nodes.size() <= edges && !this->Junctions[nodes.back()] && nodes.back() != start)
    {
      const Index from = nodes[nodes.size() - 2];
      nodes.push_back(this->Graph.NeighborBeyond(from, nodes.back()));
    }
    return nodes;
  }

  /// Whether the curve goes on in the same direction on both sides of a kink; both ways lead away
  /// from it.
  bool GoesOn(const std::vector<Index>& before, const std::vector<Index>& after) const
  {
    const bool longBefore = this->IsStretch(before);
    const bool longAfter = this->IsStretch(after);
    if (longBefore && longAfter)
    {
      return this->TurnBetween(-this->Direction(before), this->Direction(after)) <= this->Angle;
    }
    if (longBefore == longAfter)
    {
      return false;
    }
    const std::vector<Index>& stretch = longBefore ? before : after;
    const std::vector<Index>& end = longBefore ? after : before;
    if (this->Graph.Valence(end.back()) < 3 || this->TurnsAgain(end))
    {
      return false;
    }
    const Vec3 across = this->At(stretch[Apart]) - this->At(end.back());
    return this->TurnBetween(across, this->Direction(stretch)) <= 0.5 * this->Angle;
  }

  bool IsStretch(const std::vector<Index>& nodes) const
  {
    return nodes.size() > Apart + Stretch && !this->TurnsAgain(nodes);
  }

  bool TurnsAgain(const std::vector<Index>& nodes) const
  {
    return std::any_of(
      nodes.begin() + 1, nodes.end(), [&](Index node) { return this->Turns[node] != 0; });
  }

  Vec3 Direction(const std::vector<Index>& nodes) const
  {
    return this->At(nodes[Apart + Stretch]) - this->At(nodes[Apart]);
  }

  static double TurnBetween(const Vec3& from, const Vec3& to)
  {
    return AngleOfDifference(1.0 - DirectionOf(from).dot(DirectionOf(to)));
  }

  const Vec3& At(Index node) const { return this->Points[this->Graph.MeshVertex(node)]; }

  const EdgeGraph& Graph;
  const std::vector<Vec3>& Points;
  const Flags& Junctions;
  const double Angle;
  const Flags& Turns;
};
}

void ForgetKinks(const EdgeGraph& graph, const std::vector<Vec3>& points, const Flags& junctions,
  double angle, Flags& turns)
{
  const Flags found = turns; // all are judged by these, so that none is before the others
  const Straightener straightener(graph, points, junctions, angle, found);
  for (Index node = 0; node < graph.size(); ++node)
  {
    if (found[node])
    {
      for (const Index inside : straightener.KinkFrom(node))
      {
        turns[inside] = 0;
      }
    }
  }
}
}
