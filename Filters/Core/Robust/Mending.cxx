// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Mending.h"

#include "Ears.h"
#include "GiveBack.h"
#include "OtherOrders.h"
#include "Retreat.h"
#include "Straighten.h"
#include "Untangle.h"

#include <numeric>

namespace arris
{
namespace
{
void PutIntactBack(const Mesh& before, Placement& placement)
{
  for (Index v = 0; v < before.VertexCount(); ++v)
  {
    if (!placement.IsDamaged(v))
    {
      placement.SetPoint(v, before.Points[v]);
    }
  }
}

std::vector<Index> AllTriangles(const Mesh& mesh)
{
  std::vector<Index> all(mesh.Triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}
}

std::vector<Vec3> Mend(const Labelled& mesh, const std::vector<Index>& damaged,
  const Mending& mending, Placement& placement)
{
  const Placement placed = placement;
  const std::vector<Index> around = TrianglesAround(mesh.TheConnectivity, damaged);
  const auto flipEdges = [&]
  {
    if (mending.FlipEdges)
    {
      mending.FlipEdges(placement);
    }
  };
  flipEdges();
  const std::vector<Index> tangled =
    Untangle(mesh.Now, mesh.TheConnectivity, mesh.Scales, around, 0, placement);
  flipEdges();
  Straighten(mesh.Now, mesh.TheConnectivity, mesh.Labels, mesh.Before.Points, damaged, placement);
  if (mending.IsSmoothed && !mending.KeepsSmooth)
  {
    PutIntactBack(mesh.Before, placement);
  }
  LiftEars(mesh.Now, mesh.TheConnectivity, mesh.Scales, placement);
  std::vector<Vec3> wanted = placement.AllPoints();
  const std::vector<Index> moving = mending.IsSmoothed ? AllTriangles(mesh.Now) : around;
  Retreat(mesh.Safe, mesh.TheConnectivity, moving, placement);
  if (!mending.FlipEdges) // which another order would have to undo
  {
    TryOtherOrders(mesh, placed, tangled, placement, wanted);
  }
  const std::vector<Index> givenBack = GiveBackTheMoreCreased(
    mesh.Now, mesh.TheConnectivity, mesh.Region, mesh.Before.Points, placement);
  Retreat(
    mesh.Safe, mesh.TheConnectivity, TrianglesAround(mesh.TheConnectivity, givenBack), placement);
  if (mending.IsLast)
  {
    // All, as an earlier pass may have moved what this one has no part in.
    TurnBack(mesh.Before, mesh.TheConnectivity, AllTriangles(mesh.Now), placement);
  }
  return wanted;
}
}
