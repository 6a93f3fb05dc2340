// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves.h"

#include "EdgeGraph.h"
#include "Geometry.h"
#include "Kinks.h"

#include <algorithm>

namespace arris
{
namespace
{
/// Splits a graph of edges into curves.
class Splitter
{
public:
  Splitter(const std::vector<std::array<Index, 2>>& edges, const std::vector<Vec3>& points,
    const CurveSplits& splits)
    : Graph(edges)
    , Points(points)
    , Splits(splits)
    , Used(edges.size(), 0)
    , IsCorner(this->Graph.size(), 0)
  {
  }

  CurveNetwork Run()
  {
    this->FindJunctions();
    if (this->Splits.CornerAngle < 180.0)
    {
      this->FindTurns();
    }
    return this->Collect();
  }

private:
  void FindJunctions()
  {
    const std::vector<int>& sorts = this->Splits.Sorts;
    for (Index node = 0; node < this->Graph.size(); ++node)
    {
      this->IsCorner[node] = this->Graph.Valence(node) != 2 ||
          (!sorts.empty() && sorts[this->Graph.Edge(node, 0)] != sorts[this->Graph.Edge(node, 1)])
        ? 1
        : 0;
    }
  }

  /// Marks the vertices where the curve turns, once the turns at all vertices are known.
  void FindTurns()
  {
    std::vector<double> turns(this->Graph.size(), 0.0);
    for (Index node = 0; node < this->Graph.size(); ++node)
    {
      turns[node] = this->IsCorner[node]
        ? 0.0
        : std::min(this->TurnAt(node, 0.0), this->TurnAt(node, this->Splits.Reach));
    }
    Flags turned(this->IsCorner.size());
    for (Index node = 0; node < this->Graph.size(); ++node)
    {
      turned[node] = turns[node] > this->Splits.CornerAngle ? 1 : 0;
    }
    if (this->Splits.ForgetKinks)
    {
      ForgetKinks(this->Graph, this->Points, this->IsCorner, this->Splits.CornerAngle, turned);
    }
    for (Index node = 0; node < this->Graph.size(); ++node)
    {
      this->IsCorner[node] |= turned[node];
    }
  }

  /// Walks from a vertex of valence two towards one of its neighbours until a visitor has enough,
  /// a corner, or the start again. The visitor sees each vertex and how far away it is.
  template <typename Visit>
  void Walk(Index start, int way, Visit&& visit) const
  {
    Index from = start;
    Index node = this->Graph.Neighbor(start, way);
    double length = 0.0;
    while (true)
    {
      length += (this->At(node) - this->At(from)).norm();
      if (!visit(node, length) || this->IsCorner[node] || node == start)
      {
        return;
      }
      const Index next = this->Graph.NeighborBeyond(from, node);
      from = node;
      node = next;
    }
  }

  /// The turn between the chords to where the curve is `reach` away.
  double TurnAt(Index node, double reach) const
  {
    std::array<Vec3, 2> chords;
    for (const int way : { 0, 1 })
    {
      this->Walk(node, way,
        [&](Index reached, double length)
        {
          chords[way] = this->At(reached) - this->At(node);
          return length < reach && reached != node;
        });
    }
    const double length = chords[0].norm() * chords[1].norm();
    return length > 0.0 ? AngleOfDifference(1.0 + std::max(-1.0, chords[0].dot(chords[1]) / length))
                        : 0.0;
  }

  CurveNetwork Collect()
  {
    CurveNetwork network;
    for (const bool fromCorners : { true, false })
    {
      for (Index node = 0; node < this->Graph.size(); ++node)
      {
        if ((this->IsCorner[node] != 0) != fromCorners)
        {
          continue;
        }
        if (fromCorners)
        {
          network.Corners.push_back({ this->Graph.MeshVertex(node), this->Graph.Valence(node) });
        }
        for (Curve curve = this->Follow(node); !curve.empty(); curve = this->Follow(node))
        {
          network.Curves.push_back(std::move(curve));
        }
      }
    }
    return network;
  }

  /// Walks over one unused edge at the node; NoIndex if there is none.
  Index Step(Index node)
  {
    for (int i = 0; i < this->Graph.Valence(node); ++i)
    {
      unsigned char& used = this->Used[this->Graph.Edge(node, i)];
      if (!used)
      {
        used = 1;
        return this->Graph.Neighbor(node, i);
      }
    }
    return NoIndex;
  }

  /// Follows unused edges from the node up to the next corner, or back to the node.
  Curve Follow(Index start)
  {
    Curve curve;
    for (Index node = this->Step(start); node != NoIndex; node = this->Step(node))
    {
      if (curve.empty())
      {
        curve.push_back(this->Graph.MeshVertex(start));
      }
      curve.push_back(this->Graph.MeshVertex(node));
      if (this->IsCorner[node] || node == start)
      {
        break;
      }
    }
    return curve;
  }

  const Vec3& At(Index node) const { return this->Points[this->Graph.MeshVertex(node)]; }

  const EdgeGraph Graph;
  const std::vector<Vec3>& Points;
  const CurveSplits& Splits;
  Flags Used; // edges
  Flags IsCorner; // nodes
};
}

CurveNetwork JoinEdges(const std::vector<std::array<Index, 2>>& edges,
  const std::vector<Vec3>& points, const CurveSplits& splits)
{
  return Splitter(edges, points, splits).Run();
}

double LengthOf(const Curve& curve, const std::vector<Vec3>& points)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
  {
    length += (points[curve[i + 1]] - points[curve[i]]).norm();
  }
  return length;
}
}
