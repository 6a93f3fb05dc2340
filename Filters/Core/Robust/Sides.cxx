// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Sides.h"

#include "Core/Geometry.h"
#include "LocalSolid.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
// Lengths in local scales.
constexpr double SampleDepth = 3.5; // samples are this much farther away than the nearest one
constexpr double SearchRadius = SideFinder::Reach - SampleDepth; // for patches
constexpr double WeightDepth = 1.5;
constexpr std::size_t MostSides = 8;

/// λτ at which a sample's weight falls to 1/e: what bends is contaminated or another face.
constexpr double FlatnessScale = 0.2;
constexpr double BorderWeight = 0.3; // of samples that touch the sharp region
constexpr double BlendedBorderWeight = 0.1;

/// What leaves this many times as much for a plane as for a torus is curved. Extrapolated, a
/// needless curvature errs more than a plane does. Beside a blended edge the last of the blend
/// bends what is flat.
constexpr double CurvedGain = 1.5;
constexpr double BlendedCurvedGain = 8.0;

double Mixed(double sharp, double blended, double rounding)
{
  return sharp + rounding * (blended - sharp);
}

/// Samples of other patches are used where their normals differ by less than this, in degrees.
constexpr double LikeNormal = 25.0;
}

std::vector<Side> SideFinder::Find(Index vertex)
{
  std::vector<Side> sides;
  const double scale = this->Around.Scales[vertex];
  this->GatherNear(vertex, Reach * scale);
  for (const Near& near : this->Static) // nearest first
  {
    const Index patch = this->ThePatches.PatchOf[near.Vertex];
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
  LocalSolid solid;
  for (Side& side : sides)
  {
    this->Fit(vertex, side);
    solid.AddSheet(side.Surface, this->Samples);
  }
  const Vec3& x = this->Around.TheMesh.Points[vertex];
  const double active = solid.Value(x);
  constexpr double TieBreaker = 0.02;
  for (Side& side : sides)
  {
    const double s = side.Surface.Distance(x);
    side.Cost = std::abs(s - active) + TieBreaker * std::abs(s);
  }
  return sides;
}

void SideFinder::GatherNear(Index vertex, double radius)
{
  const Vec3& x = this->Around.TheMesh.Points[vertex];
  this->Seen.Clear();
  this->Seen.Insert(vertex);
  this->Queue.assign(1, vertex);
  this->Static.clear();
  for (std::size_t next = 0; next < this->Queue.size(); ++next)
  {
    for (Index n : this->Around.TheConnectivity.NeighborsOfVertex[this->Queue[next]])
    {
      const double distance = (this->Around.TheMesh.Points[n] - x).norm();
      if (distance > radius || !this->Seen.Insert(n))
      {
        continue;
      }
      this->Queue.push_back(n);
      if (!this->Region[n])
      {
        this->Static.push_back({ distance, n });
      }
    }
  }
  std::sort(this->Static.begin(), this->Static.end(),
    [](const Near& a, const Near& b)
    { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Vertex < b.Vertex; });
}

void SideFinder::Fit(Index vertex, Side& side)
{
  const double scale = this->Around.Scales[vertex];
  const double radius = side.Distance + SampleDepth * scale;
  const double width = side.Distance + WeightDepth * scale;
  const double likeCosine = std::cos(LikeNormal * Pi / 180.0);
  const double borderWeight = Mixed(BorderWeight, BlendedBorderWeight, this->Around.Rounding);
  Vec3 normal = Vec3::Zero();
  Index piece = NoIndex;
  this->Samples.clear();
  for (const Near& near : this->Static)
  {
    if (near.Distance > radius)
    {
      break;
    }
    const Index v = near.Vertex;
    const bool own = this->ThePatches.PatchOf[v] == side.Patch;
    if (piece == NoIndex && own)
    {
      piece = this->ThePatches.PieceOf[v];
      normal = this->Around.TheFaces.VertexNormals[v];
    }
    const bool alike = piece != NoIndex && this->ThePatches.PieceOf[v] == piece &&
      this->Around.TheFaces.VertexNormals[v].dot(normal) >= likeCosine;
    if (!own && !alike)
    {
      continue;
    }
    bool border = false;
    for (Index n : this->Around.TheConnectivity.NeighborsOfVertex[v])
    {
      border = border || this->Region[n];
    }
    const double d = near.Distance / width;
    const double weight = std::exp(-2.0 * d * d - this->Around.Flatness[v] / FlatnessScale) *
      (border ? borderWeight : 1.0);
    this->Samples.push_back(
      { this->Around.TheMesh.Points[v], this->Around.TheFaces.VertexNormals[v], weight });
  }
  side.Surface =
    Sheet(this->Samples, scale, Mixed(CurvedGain, BlendedCurvedGain, this->Around.Rounding));
}
}
