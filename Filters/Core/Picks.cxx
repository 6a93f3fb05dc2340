// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Picks.h"

#include "ConnectedWindow.h"
#include "Geometry.h"
#include "NormalSpread.h"
#include "SpatialWindow.h"

#include <algorithm>
#include <functional>
#include <memory>

namespace arris
{
namespace
{
/// So far, as a part of it, the angle stays below what the least sharp pick has, or above what the
/// sharpest smooth one has where there are only such: farther than rounding reaches.
constexpr double RoundingMargin = 1e-9;

/// By so much must a pick's λτ grow for a larger window to be worth it: about 5 % of its angle.
constexpr double WorthAWindow = 1.1;

/// λτ of picks, for any window radius.
class PickProbe
{
public:
  PickProbe(const Mesh& mesh, const Connectivity& connectivity, double averageEdgeLength,
    WindowSearch search)
    : Normals(UnitNormals(mesh, averageEdgeLength))
  {
    if (search == WindowSearch::Connected)
    {
      auto window = std::make_shared<ConnectedWindow>(mesh, connectivity);
      this->Gather = [window](Index vertex, double radius) -> const std::vector<Index>&
      { return window->Gather(vertex, radius); };
      return;
    }
    // The distance test after the grid is exact, so one grid serves all radii.
    this->Grid = std::make_unique<WindowGrid>(mesh, averageEdgeLength);
    auto window = std::make_shared<SpatialWindow>(mesh, connectivity, *this->Grid);
    this->Gather = [window](Index vertex, double radius) -> const std::vector<Index>&
    { return window->Gather(vertex, radius); };
  }

  double Difference(const Pick& pick, double radius)
  {
    double largest = 0.0;
    for (const Index vertex : pick)
    {
      largest =
        std::max(largest, this->Spread.Largest(this->Gather(vertex, radius), this->Normals));
    }
    return largest;
  }

private:
  std::vector<Vec3> Normals;
  std::unique_ptr<WindowGrid> Grid;
  std::function<const std::vector<Index>&(Index, double)> Gather;
  NormalSpread Spread;
};

/// The extreme picks in one window. Where there are none of a kind, they stand in nobody's way.
struct Extremes
{
  double Radius = 0.0;
  double SharpDifference = 2.0;
  double SmoothDifference = -1.0;
  std::size_t Sharp = 0;
  std::size_t Smooth = 0;

  /// The angle that the least sharp pick just reaches.
  double Threshold() const
  {
    return AngleOfDifference(this->SharpDifference) * (1.0 - RoundingMargin);
  }
  bool Separated() const
  {
    return this->SmoothDifference < 0.0 ||
      AngleOfDifference(this->SmoothDifference) + LeastPickedAngle <=
      AngleOfDifference(this->SharpDifference);
  }
};

Extremes ExtremesAt(PickProbe& probe, const Picks& picks, double radius)
{
  Extremes extremes;
  extremes.Radius = radius;
  for (std::size_t i = 0; i < picks.Sharp.size(); ++i)
  {
    const double difference = probe.Difference(picks.Sharp[i], radius);
    if (i == 0 || difference < extremes.SharpDifference)
    {
      extremes.SharpDifference = difference;
      extremes.Sharp = i;
    }
  }
  for (std::size_t i = 0; i < picks.Smooth.size(); ++i)
  {
    const double difference = probe.Difference(picks.Smooth[i], radius);
    if (i == 0 || difference > extremes.SmoothDifference)
    {
      extremes.SmoothDifference = difference;
      extremes.Smooth = i;
    }
  }
  return extremes;
}

FollowedPicks Result(PickVerdict verdict, const Extremes& at, double sharpAngle,
  const ClassificationParameters& wanted)
{
  FollowedPicks result;
  result.Verdict = verdict;
  result.Parameters = { at.Radius, sharpAngle, wanted.Search };
  result.Sharp = at.Sharp;
  result.Smooth = at.Smooth;
  result.SharpDeviation = AngleOfDifference(at.SharpDifference);
  result.SmoothDeviation = AngleOfDifference(std::max(0.0, at.SmoothDifference));
  return result;
}

double PickedRadius(int step, double averageEdgeLength)
{
  return (LeastPickedRatio + step * PickedRatioStep) * averageEdgeLength;
}

/// The window grows, as in the paper.
FollowedPicks FollowSharp(PickProbe& probe, double averageEdgeLength, const Picks& picks,
  const ClassificationParameters& wanted)
{
  const double enough = DifferenceOfAngle(wanted.SharpAngle);
  Extremes best;
  best.SharpDifference = -1.0;
  for (int step = 0; step <= PickedRatioSteps; ++step)
  {
    const Extremes at = ExtremesAt(probe, picks, PickedRadius(step, averageEdgeLength));
    const bool reaches = at.SharpDifference >= enough;
    if (at.Separated() && (reaches || at.SharpDifference > WorthAWindow * best.SharpDifference))
    {
      best = at;
      if (reaches)
      {
        break;
      }
    }
  }
  if (best.SharpDifference < 0.0)
  {
    best = ExtremesAt(probe, picks, wanted.WindowRadius);
    if (!best.Separated())
    {
      return Result(PickVerdict::Contradictory, best, wanted.SharpAngle, wanted);
    }
  }
  const bool sharp = best.SharpDifference >= DifferenceOfAngle(LeastPickedAngle);
  return Result(
    sharp ? PickVerdict::Followed : PickVerdict::NotSharp, best, best.Threshold(), wanted);
}

/// Without sharp picks there is nothing to grow for: the window that was wanted, or a smaller one.
FollowedPicks FollowSmooth(PickProbe& probe, double averageEdgeLength, const Picks& picks,
  const ClassificationParameters& wanted)
{
  const double limit = DifferenceOfAngle(wanted.SharpAngle);
  Extremes at = ExtremesAt(probe, picks, wanted.WindowRadius);
  for (int step = PickedRatioSteps; step >= 0 && at.SmoothDifference >= limit; --step)
  {
    const double radius = PickedRadius(step, averageEdgeLength);
    if (radius < at.Radius)
    {
      at = ExtremesAt(probe, picks, radius);
    }
  }
  if (at.SmoothDifference < limit)
  {
    return Result(PickVerdict::Followed, at, wanted.SharpAngle, wanted);
  }
  const double angle = AngleOfDifference(at.SmoothDifference) * (1.0 + RoundingMargin);
  return Result(PickVerdict::Followed, at, std::min(180.0, angle), wanted);
}
}

FollowedPicks FollowPicks(const Mesh& mesh, const Connectivity& connectivity,
  double averageEdgeLength, const Picks& picks, const ClassificationParameters& wanted)
{
  PickProbe probe(mesh, connectivity, averageEdgeLength, wanted.Search);
  return picks.Sharp.empty() ? FollowSmooth(probe, averageEdgeLength, picks, wanted)
                             : FollowSharp(probe, averageEdgeLength, picks, wanted);
}
}
