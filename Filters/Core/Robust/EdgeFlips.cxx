// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeFlips.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <utility>

namespace arris
{
namespace
{
/// A flip has to gain as much as tells a triangle from one without area.
constexpr double LeastGain = 0.01;

/// Each round flips edges that have no vertex in common; one flip may make room for the next.
constexpr int Rounds = 10;

/// Fewer edges than this close no fan.
constexpr Index LeastNeighbors = 3;

/// An edge from a to b, between c and d, and what its two triangles would be with the edge from c
/// to d.
struct Flip
{
  double Gain;
  std::array<Index, 2> Triangles; ///< (a, b, c) and (b, a, d), from whatever corner on
  std::array<Triangle, 2> After; ///< (c, a, d) and (d, b, c)
};

class Flipper
{
public:
  Flipper(Mesh& mesh, Connectivity& connectivity, Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , ThePlacement(placement)
  {
  }

  /// One round; returns how many were flipped.
  Index Run()
  {
    std::vector<Flip> flips = this->Wanted();
    std::sort(flips.begin(), flips.end(),
      [](const Flip& a, const Flip& b)
      { return a.Gain != b.Gain ? a.Gain > b.Gain : a.Triangles < b.Triangles; });
    Flags taken(this->TheMesh.Points.size(), 0);
    Index count = 0;
    for (const Flip& flip : flips)
    {
      const std::array<Index, 4> corners = { flip.After[0][0], flip.After[0][1], flip.After[0][2],
        flip.After[1][1] };
      if (std::any_of(corners.begin(), corners.end(), [&](Index v) { return taken[v] != 0; }))
      {
        continue;
      }
      for (Index v : corners)
      {
        taken[v] = 1;
      }
      this->Reconnect(flip);
      this->Set(flip.Triangles, flip.After);
      ++count;
    }
    return count;
  }

private:
  std::vector<Flip> Wanted()
  {
    std::vector<Flip> flips;
    for (Index t = 0; t < this->TheMesh.TriangleCount(); ++t)
    {
      if (!this->IsPoor(t))
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        Flip flip;
        if (this->Describe(t, k, flip) && this->Measure(flip))
        {
          flips.push_back(flip);
        }
      }
    }
    return flips;
  }

  bool IsPoor(Index t) const
  {
    return this->ThePlacement.LabelOf(t) != NoIndex &&
      this->ThePlacement.Quality(t) < GoodEnoughQuality;
  }

  bool IsFree(Index v) const
  {
    return this->ThePlacement.IsDamaged(v) && !this->TheConnectivity.OnBoundary[v];
  }

  /// What flipping edge k of a triangle would give; false if that may not be.
  bool Describe(Index t, int k, Flip& flip) const
  {
    const Index beyond = this->TheConnectivity.AcrossEdge[t][k];
    if (beyond == NoIndex || this->ThePlacement.LabelOf(beyond) != this->ThePlacement.LabelOf(t))
    {
      return false;
    }
    const Triangle& near = this->TheMesh.Triangles[t];
    const Triangle& far = this->TheMesh.Triangles[beyond];
    const Index a = near[k], b = near[Next(k)], c = near[Next(Next(k))];
    const int back = CornerOf(far, b);
    const Index d = far[Next(Next(back))];
    const IndexSpan around = this->TheConnectivity.NeighborsOfVertex[c];
    if (far[back] != b || far[Next(back)] != a || c == d || !this->IsFree(a) || !this->IsFree(b) ||
      !this->IsFree(c) || !this->IsFree(d) ||
      this->TheConnectivity.NeighborsOfVertex[a].size() <= LeastNeighbors ||
      this->TheConnectivity.NeighborsOfVertex[b].size() <= LeastNeighbors ||
      std::binary_search(around.begin(), around.end(), d))
    {
      return false;
    }
    flip.Triangles = { t, beyond };
    flip.After = { Triangle{ c, a, d }, Triangle{ d, b, c } };
    return true;
  }

  /// What the flip gains for the worse of its triangles; false if too little.
  bool Measure(Flip& flip)
  {
    const std::array<Triangle, 2> before = { this->TheMesh.Triangles[flip.Triangles[0]],
      this->TheMesh.Triangles[flip.Triangles[1]] };
    const Vec3 facing = (Corners(this->TheMesh, flip.Triangles[0]).AreaVector() +
      Corners(this->TheMesh, flip.Triangles[1]).AreaVector())
                          .normalized();
    const double now = this->Worse(flip.Triangles);
    this->Set(flip.Triangles, flip.After);
    flip.Gain = this->Worse(flip.Triangles) - now;
    const double unmoved = std::min(this->UnmovedQuality(flip.Triangles[0], facing),
      this->UnmovedQuality(flip.Triangles[1], facing));
    this->Set(flip.Triangles, before);
    return flip.Gain >= LeastGain && now + flip.Gain >= LeastGain && unmoved >= LeastGain;
  }

  /// What is across the edge of a triangle that starts at `corner`.
  Index& Across(Index triangle, Index corner)
  {
    return this->TheConnectivity
      .AcrossEdge[triangle][CornerOf(this->TheMesh.Triangles[triangle], corner)];
  }

  /// Lets the triangles around the edge know their new neighbours, while they have their old
  /// corners.
  void Reconnect(const Flip& flip)
  {
    const auto [near, far] = flip.Triangles;
    const auto [c, a, d] = flip.After[0];
    const Index b = flip.After[1][1];
    const Index acrossCA = this->Across(near, c), acrossBC = this->Across(near, b);
    const Index acrossAD = this->Across(far, a), acrossDB = this->Across(far, d);
    if (acrossBC != NoIndex)
    {
      this->Across(acrossBC, c) = far;
    }
    if (acrossAD != NoIndex)
    {
      this->Across(acrossAD, d) = near;
    }
    this->TheConnectivity.AcrossEdge[near] = { acrossCA, acrossAD, far };
    this->TheConnectivity.AcrossEdge[far] = { acrossDB, acrossBC, near };
  }

  void Set(const std::array<Index, 2>& triangles, const std::array<Triangle, 2>& corners)
  {
    this->TheMesh.Triangles[triangles[0]] = corners[0];
    this->TheMesh.Triangles[triangles[1]] = corners[1];
  }

  double Worse(const std::array<Index, 2>& triangles) const
  {
    return std::min(
      this->ThePlacement.Quality(triangles[0]), this->ThePlacement.Quality(triangles[1]));
  }

  double UnmovedQuality(Index t, const Vec3& facing) const
  {
    return ShapeQuality(Corners(this->TheMesh, t), facing);
  }

  Mesh& TheMesh;
  Connectivity& TheConnectivity;
  Placement& ThePlacement;
};
}

Index FlipEdges(Mesh& mesh, Connectivity& connectivity, Placement& placement)
{
  Index count = 0;
  for (int round = 0; round < Rounds; ++round)
  {
    const Index flipped = Flipper(mesh, connectivity, placement).Run();
    if (flipped == 0)
    {
      break;
    }
    count += flipped;
    Connectivity now(mesh);
    // These may be cut where no triangle ends; see OrientPatches.
    now.AcrossEdge = std::move(connectivity.AcrossEdge);
    now.OnBoundary = std::move(connectivity.OnBoundary);
    connectivity = std::move(now);
  }
  return count;
}
}
