// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Robust.h"

#include "Core/Geometry.h"
#include "Core/StopWatch.h"
#include "Core/Thinning.h"
#include "Placement.h"
#include "Region.h"
#include "Retreat.h"
#include "Ridge.h"
#include "ThinFaces.h"
#include "Untangle.h"

#include <algorithm>

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

std::vector<Index> VerticesIn(const Flags& region)
{
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (region[v])
    {
      vertices.push_back(static_cast<Index>(v));
    }
  }
  return vertices;
}

/// For each vertex of the region how many edges it is away from the intact ones; -1 outside.
std::vector<int> DistancesFromIntact(const Connectivity& connectivity, const Flags& region)
{
  std::vector<int> rounds(region.size(), NeverSharp);
  constexpr int Unreached = 0;
  std::vector<Index> front;
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (region[v])
    {
      rounds[v] = Unreached;
    }
    else
    {
      front.push_back(static_cast<Index>(v));
    }
  }
  for (int round = 1; !front.empty(); ++round)
  {
    std::vector<Index> next;
    for (Index v : front)
    {
      for (Index n : connectivity.NeighborsOfVertex[v])
      {
        if (rounds[n] == Unreached)
        {
          rounds[n] = round;
          next.push_back(n);
        }
      }
    }
    front.swap(next);
  }
  for (int& round : rounds) // a part that is damaged all over has no intact vertex to count from
  {
    round = round == Unreached ? 1 : round;
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

/// Fits the sides of all damaged vertices and floods their labels; false if stopped.
bool LabelVertices(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& scales, const RobustResult& result, const Patches& patches,
  const std::vector<Index>& damaged, const Monitor& monitor, Labelling& labelling)
{
  labelling.SidesOf.assign(mesh.Points.size(), NoIndex);
  for (std::size_t i = 0; i < damaged.size(); ++i)
  {
    labelling.SidesOf[damaged[i]] = static_cast<Index>(i);
  }
  labelling.Sides.resize(damaged.size());
  const bool finished = ParallelFor(static_cast<Index>(damaged.size()), monitor,
    [&](Index begin, Index end)
    {
      SideFinder finder(
        mesh, connectivity, faces, scales, result.NormalDifferences, result.Region, patches);
      for (Index i = begin; i < end; ++i)
      {
        labelling.Sides[i] = finder.Find(damaged[i]);
      }
    });
  if (finished)
  {
    labelling.Labels =
      FloodLabels(mesh, connectivity, patches, result.Region, labelling.Sides, labelling.SidesOf);
  }
  return finished;
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
  result.Region = FindSharpRegion(mesh, connectivity, turns, scales);
  SpareThinFaces(mesh, connectivity, faces, scales, result.Region);
  const Patches patches =
    SortIntoPatches(mesh, connectivity, faces, result.NormalDifferences, result.Region);

  const std::vector<Index> damaged = VerticesIn(result.Region);
  result.ClassificationSeconds = classification.Seconds();

  const StopWatch thinning;
  Labelling labelling;
  if (!LabelVertices(mesh, connectivity, faces, scales, result, patches, damaged,
        monitor.Part(Measured, Fitted), labelling))
  {
    return result;
  }
  const Ridge ridge = FindRidge(mesh, connectivity, faces, labelling);
  result.ThinningSeconds = thinning.Seconds();

  const StopWatch sharpening;
  Placement placement(mesh, connectivity, labelling, scales, ridge.FaceLabels);
  for (Index v : damaged)
  {
    placement.Place(v);
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
