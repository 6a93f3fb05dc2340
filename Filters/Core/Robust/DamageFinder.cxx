// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DamageFinder.h"

#include "Core/Flagged.h"
#include "Core/Geometry.h"
#include "Junctions.h"
#include "MeetingEdges.h"
#include "ThinFaces.h"

#include <algorithm>
#include <utility>

namespace arris
{
namespace
{
/// As far as a turn looks, in edges, and as far as its window: where that is flat nothing else is
/// looked at.
constexpr int TurnReach = 6;
constexpr int WindowReach = 3;

/// A window that the user has set is the same everywhere; all else about a turn goes with it.
std::vector<double> TurnScales(const std::vector<double>& localScales, double windowRadius)
{
  return windowRadius > 0.0 ? std::vector<double>(localScales.size(), windowRadius / TurnWindow)
                            : localScales;
}
}

DamageFinder::DamageFinder(const Connectivity& connectivity, const std::vector<double>& localScales,
  const RobustParameters& parameters, const Roughness& rough, const Whole* together)
  : Angles(EdgeAngles::Of(rough, parameters.SharpAngle))
  , TheConnectivity(connectivity)
  , Rough(rough)
  , Together(together)
  , LocalScales(localScales)
  , Scales(TurnScales(localScales, parameters.WindowRadius))
{
}

bool DamageFinder::Find(const Mesh& mesh, const Faces& faces, const Flags& before,
  const Flags& moved, const Monitor& monitor)
{
  const bool first = this->Turns.empty();
  if (!this->MeasureTurns(mesh, faces, moved, monitor))
  {
    return false;
  }
  SharpRegion sharp =
    FindSharpRegion(mesh, this->TheConnectivity, this->Turns, this->Scales, this->Angles);
  this->Region = std::move(sharp.Vertices);
  if (first)
  {
    this->Rounding = sharp.Rounding;
  }
  for (std::size_t v = 0; v < this->Region.size(); ++v)
  {
    this->Region[v] |= before[v];
  }
  const bool blurred = this->Rounding > BlurRounding;
  ExtendToOtherEdges(mesh, this->TheConnectivity, faces, this->Scales, this->Turns, this->Angles,
    blurred || this->Rough.Degree > 0.0, this->Region);
  if (this->Together)
  {
    AddJunctions(this->Together->Apart, mesh.Points, this->LocalScales, this->Region);
  }
  if (!blurred) // a blur leaves no narrow face flat
  {
    SpareThinFaces(mesh, this->TheConnectivity, faces, this->LocalScales, this->Region);
  }
  return true;
}

bool DamageFinder::MeasureTurns(
  const Mesh& mesh, const Faces& faces, const Flags& moved, const Monitor& monitor)
{
  // Where something has moved since a turn was measured last, at first everywhere.
  const bool first = this->Turns.empty();
  this->Turns.resize(mesh.Points.size());
  const std::vector<int> away = first ? std::vector<int>(this->Turns.size(), 0)
                                      : EdgesAwayFrom(this->TheConnectivity, moved, TurnReach);
  return ParallelFor(mesh.VertexCount(), monitor,
    [&](Index begin, Index end)
    {
      TurnMeter meter(mesh, this->TheConnectivity, faces, this->Scales);
      for (Index v = begin; v < end; ++v)
      {
        const int most = this->Turns[v].Deviation < FlatDeviation ? WindowReach : TurnReach;
        if (away[v] >= 0 && away[v] <= most)
        {
          this->Turns[v] = meter.Measure(v);
        }
      }
    });
}

void DamageFinder::TellTurns(RobustResult& result) const
{
  result.WindowRadii.resize(this->Turns.size());
  result.NormalDifferences.resize(this->Turns.size());
  result.Jumps.resize(this->Turns.size());
  for (std::size_t v = 0; v < this->Turns.size(); ++v)
  {
    result.WindowRadii[v] = TurnWindow * this->Scales[v];
    result.NormalDifferences[v] = DifferenceOfAngle(this->Turns[v].Deviation);
    result.Jumps[v] = std::max(0.0, this->Turns[v].Jump);
  }
}
}
