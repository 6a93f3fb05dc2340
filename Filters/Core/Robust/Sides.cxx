// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Sides.h"

#include "Core/Geometry.h"
#include "Mixed.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
// Lengths in local scales.
constexpr double SearchRadius = 4.5; // for patches
constexpr double SampleDepth = 3.5; // samples are this much farther away than the nearest one
constexpr double RoughSampleDepth = 5.0;
constexpr double WeightDepth = 1.5;
constexpr double RoughWeightDepth = 2.5;
constexpr std::size_t MostSides = 8;

/// Where a blur has been undone there are samples near, but those in its reach (in its widths) are
/// the less certain: sheets are fitted as widely as if none were in it.
constexpr double UnblurredDistance = 5.0;

constexpr double BorderWeight = 0.3; // of samples that touch the sharp region
constexpr double BlendedBorderWeight = 0.1;

/// How many times as much a plane must leave as a torus beside a blended edge: the last of the
/// blend bends what is flat. Rough meshes are rounded too, but there their roughness already keeps
/// planes from being given up.
constexpr double BlendedCurvedGain = 8.0;

// Of a rough mesh: what is left after smoothing bends no plane, and says little of curvature.
constexpr double RoughFlatResidual = 0.0375;
constexpr double RoughRidge = 1e-3;

/// Samples of other patches are used where their normals differ by less than this, in degrees.
constexpr double LikeNormal = 25.0;
}

double SideFinder::Reach(double roughness)
{
  return SearchRadius + Mixed(SampleDepth, RoughSampleDepth, roughness);
}

std::vector<Side> SideFinder::FitAround(Index vertex, LocalSolid& solid)
{
  std::vector<Side> sides;
  const double scale = this->Around.Scales[vertex];
  this->GatherStatic(vertex, Reach(this->Around.Roughness) * scale);
  for (const NearVertex& near : this->Static) // nearest first
  {
    const Index patch = this->From.ThePatches.PatchOf[near.Vertex];
    const bool known = std::any_of(
      sides.begin(), sides.end(), [patch](const Side& side) { return side.Patch == patch; });
    if (!known && sides.size() < MostSides && near.Distance <= SearchRadius * scale)
    {
      sides.push_back({ patch, Sheet(), near.Distance, 0.0 });
    }
  }
  if (sides.empty())
  {
    return sides;
  }
  for (Side& side : sides)
  {
    this->Fit(vertex, side);
    solid.AddSheet(side.Surface, this->Fitted);
  }
  solid.Close();
  return sides;
}

LocalSolid SideFinder::Find(IndexSpan vertices, const std::vector<std::vector<Side>*>& sides)
{
  LocalSolid solid;
  const std::vector<Side> shared = this->FitAround(*vertices.begin(), solid);
  auto row = sides.begin();
  for (Index v : vertices)
  {
    std::vector<Side>& own = **row++;
    own = shared;
    if (own.empty())
    {
      continue;
    }
    const Vec3& x = this->Around.TheMesh.Points[v];
    const double active = solid.Distance(x);
    constexpr double TieBreaker = 0.02;
    for (Side& side : own)
    {
      const double s = side.Surface.Distance(x);
      side.Cost = std::abs(s - active) + TieBreaker * std::abs(s);
    }
  }
  return solid;
}

void SideFinder::GatherStatic(Index vertex, double radius)
{
  const std::vector<Vec3>& points = this->From.Points;
  const Vec3& x = this->Around.TheMesh.Points[vertex];
  this->Static.clear();
  for (Index v : this->Near.Gather(points, this->Around.TheConnectivity, vertex, x, radius))
  {
    if (!this->From.Region[v])
    {
      this->Static.push_back({ (points[v] - x).norm(), v });
    }
  }
  std::sort(this->Static.begin(), this->Static.end(),
    [](const NearVertex& a, const NearVertex& b)
    { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Vertex < b.Vertex; });
}

void SideFinder::Fit(Index vertex, Side& side)
{
  const double scale = this->Around.Scales[vertex];
  const double roughness = this->Around.Roughness;
  const double distance = std::max(side.Distance, UnblurredDistance * this->From.BlurWidth * scale);
  const double radius = distance + Mixed(SampleDepth, RoughSampleDepth, roughness) * scale;
  const double width = distance + Mixed(WeightDepth, RoughWeightDepth, roughness) * scale;
  const double likeCosine = std::cos(LikeNormal * Pi / 180.0);
  const double borderWeight = Mixed(BorderWeight, BlendedBorderWeight, this->Around.Rounding);
  Vec3 normal = Vec3::Zero();
  Index piece = NoIndex;
  this->Fitted.clear();
  for (const NearVertex& near : this->Static)
  {
    if (near.Distance > radius)
    {
      break;
    }
    const Index v = near.Vertex;
    const bool own = this->From.ThePatches.PatchOf[v] == side.Patch;
    if (piece == NoIndex && own)
    {
      piece = this->From.ThePatches.PieceOf[v];
      normal = this->From.Normals[v];
    }
    const bool alike = piece != NoIndex && this->From.ThePatches.PieceOf[v] == piece &&
      this->From.Normals[v].dot(normal) >= likeCosine;
    if (!own && !alike)
    {
      continue;
    }
    bool border = false;
    for (Index n : this->Around.TheConnectivity.NeighborsOfVertex[v])
    {
      border = border || this->From.Region[n];
    }
    const double d = near.Distance / width;
    const double weight = std::exp(-2.0 * d * d - this->From.Flatness[v] / FlatnessScale) *
      (border ? borderWeight : 1.0);
    this->Fitted.push_back({ this->From.Points[v], this->From.Normals[v], weight });
  }
  SheetCaution caution;
  caution.CurvedGain =
    Mixed(caution.CurvedGain, BlendedCurvedGain, this->Around.Rounding * (1.0 - roughness));
  caution.FlatResidual = Mixed(caution.FlatResidual, RoughFlatResidual, roughness);
  caution.Ridge = Mixed(caution.Ridge, RoughRidge, roughness);
  side.Surface = Sheet(this->Fitted, scale, caution);
  side.Surface.Unblur(this->From.BlurWidth * scale);
}
}
