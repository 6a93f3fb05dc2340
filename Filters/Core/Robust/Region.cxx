// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Region.h"

#include "Core/Flagged.h"
#include "Core/Parallel.h"
#include "Mixed.h"
#include "Spread.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
// Angles in degrees; lengths in local scales.
constexpr double SeedConcentration = 0.35; // E over J: a fillet or a cylinder spreads its turn
constexpr double LeastAcross = 6.0;
constexpr std::size_t SmallestSeedGroup = 6;

constexpr double Reach = 1.6; // from a seed
constexpr double ReachBlend = 1.2;
constexpr double Dilation = 1.4; // of a blended edge's region

class RegionFinder
{
public:
  RegionFinder(const Mesh& mesh, const Connectivity& connectivity, const std::vector<Turn>& turns,
    const std::vector<double>& scales, const EdgeAngles& angles)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , Turns(turns)
    , Scales(scales)
    , Angles(angles)
    , Seeds(mesh.Points.size())
    , Blend(mesh.Points.size(), 0.0)
  {
  }

  SharpRegion Find()
  {
    ParallelFor(this->TheMesh.VertexCount(),
      [this](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          const Turn& turn = this->Turns[v];
          this->Seeds[v] =
            ShowsEdge(turn, this->Angles) || turn.Deviation >= this->Angles.Corner ? 1 : 0;
        }
      });
    this->DropSmallGroups();
    this->FindBlendDegrees();
    const double rounding = this->Rounding();
    for (std::size_t v = 0; v < this->Seeds.size(); ++v)
    {
      this->Blend[v] = this->Seeds[v] ? std::max(this->Blend[v], rounding) : 0.0;
    }
    Flags region = this->Grow();
    this->Dilate(region);
    this->FillHoles(region);
    return { std::move(region), rounding };
  }

private:
  void DropSmallGroups()
  {
    Flags kept = this->Seeds;
    ForEachGroup(this->TheConnectivity, this->Seeds, 1,
      [&](const std::vector<Index>& group)
      {
        if (group.size() < SmallestSeedGroup)
        {
          for (Index v : group)
          {
            kept[v] = 0;
          }
        }
      });
    this->Seeds.swap(kept);
  }

  /// X of each seed: 0 at a sharp edge, 1 at a blended one, by how much the jump shrinks when the
  /// sides are taken from farther out, averaged along the edge.
  void FindBlendDegrees()
  {
    constexpr double SharpRatio = 0.93; // J(1, 3) / J(1.5, 3.5): about 1 sharp, about 0.8 blended
    constexpr double RatioRange = 0.04;
    constexpr int Smoothing = 20;
    std::vector<std::array<double, 2>> now(this->Seeds.size(), { 0.0, 0.0 });
    for (Index v = 0; v < this->TheMesh.VertexCount(); ++v)
    {
      const Turn& turn = this->Turns[v];
      if (this->Seeds[v] && turn.WideJump > this->Angles.Grown && turn.Jump > this->Angles.Grown &&
        this->IsRidge(v))
      {
        now[v] = { std::min(turn.Jump / turn.WideJump, 1.5), 1.0 };
      }
    }
    const std::vector<Index> seeds = Flagged(this->Seeds);
    std::vector<std::array<double, 2>> next = now;
    for (int pass = 0; pass < Smoothing; ++pass)
    {
      for (Index v : seeds)
      {
        std::array<double, 2> sum = now[v];
        for (Index n : this->TheConnectivity.NeighborsOfVertex[v])
        {
          sum[0] += now[n][0];
          sum[1] += now[n][1];
        }
        const double share = 1.0 / (1.0 + this->TheConnectivity.NeighborsOfVertex[v].size());
        next[v] = { sum[0] * share, sum[1] * share };
      }
      now.swap(next);
    }
    for (Index v : seeds)
    {
      if (now[v][1] > 0.0)
      {
        this->Blend[v] = std::clamp((SharpRatio - now[v][0] / now[v][1]) / RatioRange, 0.0, 1.0);
      }
    }
  }

  /// What the sampling does to all edges: one may look rounded for what is beside it, but on
  /// average those that were only cut off do not.
  double Rounding() const
  {
    constexpr double LeastMean = 0.2; // measured on contours: up to 0.13
    constexpr double MostMean = 0.5; // on contours of blurred distances: from 0.56
    double sum = 0.0, count = 0.0;
    for (std::size_t v = 0; v < this->Seeds.size(); ++v)
    {
      sum += this->Seeds[v] ? this->Blend[v] : 0.0;
      count += this->Seeds[v];
    }
    const double mean = count > 0.0 ? sum / count : 0.0;
    return std::clamp((mean - LeastMean) / (MostMean - LeastMean), 0.0, 1.0);
  }

  bool IsRidge(Index v) const
  {
    for (Index n : this->TheConnectivity.NeighborsOfVertex[v])
    {
      if (this->Turns[n].Concentrated > this->Turns[v].Concentrated)
      {
        return false;
      }
    }
    return true;
  }

  Flags Grow()
  {
    Flags region(this->Seeds.size(), 0);
    SpreadFrom(
      this->Seeds, this->TheMesh.Points, this->TheConnectivity,
      [&](Index v, double distance, Index seed)
      {
        // Concentrated: the window turns by more than the curvature of the sides would make it.
        const Turn& turn = this->Turns[v];
        return turn.Jump >= this->Angles.Grown && turn.Across >= LeastAcross &&
          turn.Concentrated >= 0.0 &&
          distance <= (Reach + ReachBlend * this->Blend[seed]) * this->Scales[seed];
      },
      [&](Index v, Index seed)
      {
        region[v] = 1;
        this->Blend[v] = std::max(this->Blend[v], this->Blend[seed]);
      });
    return region;
  }

  /// The flanks of a blended edge are bent beyond where the turn shows.
  void Dilate(Flags& region)
  {
    Flags blended(region.size(), 0);
    for (std::size_t v = 0; v < region.size(); ++v)
    {
      blended[v] = region[v] && this->Blend[v] > 0.0 ? 1 : 0;
    }
    SpreadFrom(
      blended, this->TheMesh.Points, this->TheConnectivity,
      [&](Index, double distance, Index seed)
      { return distance <= Dilation * this->Blend[seed] * this->Scales[seed]; },
      [&](Index v, Index) { region[v] = 1; });
  }

  /// One or two vertices left over inside the region are part of it.
  void FillHoles(Flags& region) const
  {
    std::vector<Index> filled;
    for (Index inside : Flagged(region))
    {
      for (Index v : this->TheConnectivity.NeighborsOfVertex[inside])
      {
        if (!region[v] && this->IsHole(v, region))
        {
          filled.push_back(v);
        }
      }
    }
    for (Index v : filled)
    {
      region[v] = 1;
    }
  }

  /// Whether an intact vertex has no intact neighbour, or just one that has no other.
  bool IsHole(Index v, const Flags& region) const
  {
    Index other = NoIndex;
    for (Index n : this->TheConnectivity.NeighborsOfVertex[v])
    {
      if (!region[n])
      {
        if (other != NoIndex)
        {
          return false;
        }
        other = n;
      }
    }
    if (other == NoIndex)
    {
      return true;
    }
    const IndexSpan around = this->TheConnectivity.NeighborsOfVertex[other];
    return std::all_of(
      around.begin(), around.end(), [&](Index n) { return n == v || region[n] != 0; });
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const std::vector<Turn>& Turns;
  const std::vector<double>& Scales;
  const EdgeAngles& Angles;
  Flags Seeds;
  std::vector<double> Blend;
};
}

EdgeAngles EdgeAngles::Of(const Roughness& rough, double setAngle)
{
  // Of a segmentation, rounded once by its maker and once more by the smooth copy, an edge of 30
  // degrees shows 12; its smooth faces 3 to 5 (of 95 in 100 vertices).
  constexpr double TerracedSeed = 13.0;
  constexpr double TerracedGrown = 10.0;
  // What is left of noise in the smooth copy looks like shallow edges itself.
  constexpr double NoisySeed = 22.0;
  constexpr double NoisyGrown = 16.0;
  EdgeAngles angles;
  if (setAngle > 0.0)
  {
    angles.Grown *= setAngle / angles.Seed;
    angles.Seed = setAngle;
    angles.Corner = std::max(angles.Corner, setAngle);
  }
  else
  {
    angles.Seed = Mixed(Mixed(angles.Seed, TerracedSeed, rough.Degree), NoisySeed, rough.Noise);
    angles.Grown = Mixed(Mixed(angles.Grown, TerracedGrown, rough.Degree), NoisyGrown, rough.Noise);
  }
  return angles;
}

bool ShowsEdge(const Turn& turn, const EdgeAngles& angles)
{
  return turn.Across >= LeastAcross && turn.Jump >= angles.Seed &&
    turn.Concentrated >= SeedConcentration * turn.Jump;
}

SharpRegion FindSharpRegion(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Turn>& turns, const std::vector<double>& scales, const EdgeAngles& angles)
{
  return RegionFinder(mesh, connectivity, turns, scales, angles).Find();
}
}
