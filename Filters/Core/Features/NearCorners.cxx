// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NearCorners.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
/// As near as edges of a recovered mesh are expected to be to the true ones, in edges.
constexpr double TinyPart = 0.1;

/// A curve of so many edges is sampled.
constexpr std::size_t FewestEdges = 4;

/// Curves run the same way within this angle, in degrees.
constexpr double Alike = 20.0;

/// The ends of curves at a vertex, but for those of one curve.
struct End
{
  Index Curve;
  bool AtFront;
};

/// A tiny curve and what there is to know of its ends.
class Joint
{
public:
  Joint(const std::vector<Vec3>& points, const CurveNetwork& network, Index tiny)
    : Points(points)
    , Network(network)
    , Tiny(tiny)
    , AtFront(this->EndsAt(network.Curves[tiny].front()))
    , AtBack(this->EndsAt(network.Curves[tiny].back()))
  {
  }

  bool IsOneCorner() const
  {
    if (this->AtFront.size() < 2 || this->AtBack.size() < 2)
    {
      return false; // a turn, or a free end
    }
    double sum = 0.0;
    for (const auto& ends : { this->AtFront, this->AtBack })
    {
      for (const End& end : ends)
      {
        if (this->Network.Curves[end.Curve].size() <= FewestEdges)
        {
          return false;
        }
        sum += this->FirstEdge(end).norm();
      }
    }
    const double mean = sum / static_cast<double>(this->AtFront.size() + this->AtBack.size());
    return LengthOf(this->Network.Curves[this->Tiny], this->Points) < TinyPart * mean &&
      !this->AnyRunAlike();
  }

  const std::vector<End>& EndsAtFront() const { return this->AtFront; }
  const std::vector<End>& EndsAtBack() const { return this->AtBack; }

private:
  std::vector<End> EndsAt(Index vertex) const
  {
    std::vector<End> ends;
    for (std::size_t i = 0; i < this->Network.Curves.size(); ++i)
    {
      const Curve& curve = this->Network.Curves[i];
      if (static_cast<Index>(i) == this->Tiny)
      {
        continue;
      }
      if (curve.front() == vertex)
      {
        ends.push_back({ static_cast<Index>(i), true });
      }
      if (curve.back() == vertex)
      {
        ends.push_back({ static_cast<Index>(i), false });
      }
    }
    return ends;
  }

  /// From the corner on.
  Vec3 FirstEdge(const End& end) const
  {
    const Curve& curve = this->Network.Curves[end.Curve];
    return end.AtFront ? this->Points[curve[1]] - this->Points[curve[0]]
                       : this->Points[curve[curve.size() - 2]] - this->Points[curve.back()];
  }

  bool AnyRunAlike() const
  {
    const double mostCosine = std::cos(Alike * Pi / 180.0);
    return std::any_of(this->AtFront.begin(), this->AtFront.end(),
      [&](const End& a)
      {
        return std::any_of(this->AtBack.begin(), this->AtBack.end(),
          [&](const End& b) {
            return DirectionOf(this->FirstEdge(a)).dot(DirectionOf(this->FirstEdge(b))) >
              mostCosine;
          });
      });
  }

  const std::vector<Vec3>& Points;
  const CurveNetwork& Network;
  const Index Tiny;
  const std::vector<End> AtFront, AtBack;
};

std::vector<CurveCorner>::iterator FindCorner(std::vector<CurveCorner>& corners, Index vertex)
{
  return std::lower_bound(corners.begin(), corners.end(), vertex,
    [](const CurveCorner& corner, Index key) { return corner.Vertex < key; });
}

/// Lets the curves that end at the far end of a tiny curve go on along it.
void GoOnAlong(Curve way, const std::vector<End>& ends, CurveNetwork& network)
{
  for (const End& end : ends)
  {
    Curve& curve = network.Curves[end.Curve];
    if (end.AtFront)
    {
      curve.insert(curve.begin(), way.begin(), way.end() - 1);
    }
    else
    {
      curve.insert(curve.end(), way.rbegin() + 1, way.rend());
    }
  }
}
}

void MergeNearCorners(const std::vector<Vec3>& points, CurveNetwork& network)
{
  for (std::size_t i = 0; i < network.Curves.size();)
  {
    const Curve tiny = network.Curves[i];
    const Joint joint(points, network, static_cast<Index>(i));
    if (IsClosed(tiny) || !joint.IsOneCorner())
    {
      ++i;
      continue;
    }
    const auto front = FindCorner(network.Corners, tiny.front());
    const auto back = FindCorner(network.Corners, tiny.back());
    const bool keepFront = front->Valence != back->Valence ? front->Valence > back->Valence
                                                           : front->Vertex < back->Vertex;
    const auto kept = keepFront ? front : back;
    const auto gone = keepFront ? back : front;
    kept->Valence += gone->Valence - 2;
    GoOnAlong(keepFront ? tiny : Curve(tiny.rbegin(), tiny.rend()),
      keepFront ? joint.EndsAtBack() : joint.EndsAtFront(), network);
    network.Corners.erase(gone);
    network.Curves.erase(network.Curves.begin() + i);
  }
}
}
