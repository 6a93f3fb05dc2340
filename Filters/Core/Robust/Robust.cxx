// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Robust.h"

#include "Apexes.h"
#include "Core/Flagged.h"
#include "Core/Geometry.h"
#include "Core/StopWatch.h"
#include "Core/Thinning.h"
#include "MeetingEdges.h"
#include "Placement.h"
#include "Region.h"
#include "Retreat.h"
#include "Ridge.h"
#include "ThinFaces.h"
#include "Untangle.h"

#include <algorithm>
#include <limits>

namespace arris
{
namespace
{
// How far the progress has come after measuring turns, and after fitting sides.
constexpr double Measured = 0.4;
constexpr double Fitted = 0.8;

std::vector<Turn> MeasureTurns(const Mesh& mesh, const Connectivity& connectivity,
  const Faces& faces, const std::vector<double>& scales, const Monitor& monitor)
{
  std::vector<Turn> turns(mesh.Points.size());
  const bool finished = ParallelFor(mesh.VertexCount(), monitor,
    [&](Index begin, Index end)
    {
      TurnMeter meter(mesh, connectivity, faces, scales);
      for (Index v = begin; v < end; ++v)
      {
        turns[v] = meter.Measure(v);
      }
    });
  return finished ? turns : std::vector<Turn>();
}

/// For each vertex of the region how many edges it is away from the intact ones; -1 outside.
std::vector<int> DistancesFromIntact(const Connectivity& connectivity, const Flags& region)
{
  Flags intact(region.size());
  std::transform(region.begin(), region.end(), intact.begin(),
    [](unsigned char damaged) { return static_cast<unsigned char>(damaged ? 0 : 1); });
  std::vector<int> rounds = EdgesAwayFrom(connectivity, intact, std::numeric_limits<int>::max());
  for (std::size_t v = 0; v < rounds.size(); ++v)
  {
    // A part that is damaged all over has no intact vertex to count from.
    rounds[v] = region[v] ? std::max(rounds[v], 1) : NeverSharp;
  }
  return rounds;
}

/// The part of a damaged vertex by the number of its ridges' other ends.
SkeletonRole RoleOf(const Connectivity& connectivity, const Placement& placement, Index v)
{
  const std::size_t faces = placement.SheetsOf(v).size();
  if (faces < 2)
  {
    return SkeletonRole::None;
  }
  if (faces > 2)
  {
    return SkeletonRole::Joint;
  }
  int ridges = 0;
  for (Index n : connectivity.NeighborsOfVertex[v])
  {
    ridges += placement.IsDamaged(n) && placement.SheetsOf(n).size() > 1 ? 1 : 0;
  }
  return ridges > 1 ? SkeletonRole::Branch : SkeletonRole::End;
}

void TellSkeleton(const Connectivity& connectivity, const Placement& placement,
  const std::vector<Index>& damaged, RobustResult& result)
{
  result.Roles.assign(result.Region.size(), SkeletonRole::None);
  result.Rounds = DistancesFromIntact(connectivity, result.Region);
  const int last =
    damaged.empty() ? 0 : *std::max_element(result.Rounds.begin(), result.Rounds.end());
  for (Index v : damaged)
  {
    result.Roles[v] = RoleOf(connectivity, placement, v);
    if (result.Roles[v] != SkeletonRole::None)
    {
      result.Rounds[v] = last + 1;
    }
  }
}
}

RobustResult RecoverRobustly(const Mesh& mesh, const Connectivity& connectivity,
  double averageEdgeLength, const Monitor& monitor)
{
  RobustResult result;
  const StopWatch classification;
  const Faces faces(mesh, connectivity, averageEdgeLength);
  const std::vector<double> scales = LocalScales(mesh, connectivity);
  const std::vector<Turn> turns =
    MeasureTurns(mesh, connectivity, faces, scales, monitor.Part(0.0, Measured));
  if (turns.size() != mesh.Points.size())
  {
    return result;
  }
  result.WindowRadii.resize(turns.size());
  result.NormalDifferences.resize(turns.size());
  for (std::size_t v = 0; v < turns.size(); ++v)
  {
    result.WindowRadii[v] = TurnWindow * scales[v];
    result.NormalDifferences[v] = DifferenceOfAngle(turns[v].Deviation);
  }
  SharpRegion sharp = FindSharpRegion(mesh, connectivity, turns, scales);
  result.Region = std::move(sharp.Vertices);
  ExtendToOtherEdges(mesh, connectivity, faces, scales, turns, result.Region);
  SpareThinFaces(mesh, connectivity, faces, scales, result.Region);
  result.ClassificationSeconds = classification.Seconds();

  const StopWatch thinning;
  const Surroundings around{ mesh, connectivity, faces, scales, result.NormalDifferences,
    sharp.Rounding };
  Labelling labelling;
  if (!LabelVertices(around, monitor.Part(Measured, Fitted), result.Region, labelling))
  {
    return result;
  }
  const std::vector<Apex> apexes = FindApexes(around, result.Region, labelling);
  const Ridge ridge = FindRidge(mesh, connectivity, faces, labelling);
  result.ThinningSeconds = thinning.Seconds();

  const StopWatch sharpening;
  Placement placement(mesh, connectivity, labelling, scales, ridge.FaceLabels);
  const std::vector<Index> damaged = Flagged(result.Region);
  for (Index v : damaged)
  {
    placement.Place(v);
  }
  for (const Apex& apex : apexes)
  {
    for (Index v : apex.Members)
    {
      placement.Pin(v, v == apex.Vertex ? apex.Tip : mesh.Points[v]);
    }
  }
  Untangle(mesh, connectivity, scales, placement);
  Retreat(mesh, connectivity, placement);
  TellSkeleton(connectivity, placement, damaged, result);
  result.SharpeningSeconds = sharpening.Seconds();
  if (monitor.Report(1.0))
  {
    result.Points = placement.TakePoints();
  }
  return result;
}
}
