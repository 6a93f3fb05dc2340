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
constexpr double BlurredSearchRadius = 6.0; // the region of a blurred edge is wider
constexpr double SampleDepth = 3.5; // samples are this much farther away than the nearest one
constexpr double RoughSampleDepth = 5.0;
constexpr double WeightDepth = 1.5;
constexpr double RoughWeightDepth = 2.5;
constexpr std::size_t MostSides = 8;

/// Where a blur has been undone there are samples near, but those in its reach (in its widths) are
/// the less certain: sheets are fitted as widely as if none were in it. Less widely where all are
/// rough alike.
constexpr double UnblurredDistance = 7.0;
constexpr double RoughUnblurredDistance = 5.0;

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

/// Around a rod or bore of few edges' radius there are few such samples. Those whose normals differ
/// by less than this are tried as well.
constexpr double WiderNormal = 60.0;

/// Linear interpolation along the edges of a grid leaves that much of a curvature.
constexpr double OfInterpolation = 0.04;

/// A face of another patch is the continuation of one if a single sheet leaves no more than this of
/// either (rms, in scales), or this many times what it left of the one: then it is nowhere farther
/// off than that.
constexpr double OneFace = 0.005;
constexpr double OneFaceGrowth = 1.5;

/// The root mean square distance of some samples from a sheet.
double MisfitOf(
  const Sheet& sheet, const std::vector<SheetSample>& samples, std::size_t first, std::size_t last)
{
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = first; i < last; ++i)
  {
    const double distance = sheet.Distance(samples[i].Position);
    sum += samples[i].Weight * distance * distance;
    weights += samples[i].Weight;
  }
  return weights > 0.0 ? std::sqrt(sum / weights) : 0.0;
}

/// Whether a sheet is no farther than `most` from the samples up to `split`, and from the others.
bool SuitsBoth(
  const Sheet& sheet, const std::vector<SheetSample>& samples, std::size_t split, double most)
{
  return MisfitOf(sheet, samples, 0, split) <= most &&
    MisfitOf(sheet, samples, split, samples.size()) <= most;
}
}

double SideFinder::PatchReach(const Surroundings& around)
{
  return Mixed(SearchRadius, BlurredSearchRadius, around.Rounding);
}

double SideFinder::Reach(const Surroundings& around)
{
  return PatchReach(around) + Mixed(SampleDepth, RoughSampleDepth, around.Rough.Degree);
}

std::vector<Side> SideFinder::FitAround(Index vertex, LocalSolid& solid)
{
  std::vector<Side> sides;
  const double scale = this->Around.Scales[vertex];
  this->GatherStatic(vertex, Reach(this->Around) * scale);
  for (const NearVertex& near : this->Static) // nearest first
  {
    const Index patch = this->From.ThePatches.PatchOf[near.Vertex];
    const bool known = std::any_of(
      sides.begin(), sides.end(), [patch](const Side& side) { return side.Patch == patch; });
    if (!known && sides.size() < MostSides && near.Distance <= PatchReach(this->Around) * scale)
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
  const Vec3& x = this->Around.TheMesh.Points[vertex];
  this->Static.clear();
  for (Index v :
    this->Near.Gather(this->From.Points, this->Around.TheConnectivity, vertex, x, radius))
  {
    if (!this->From.Region[v])
    {
      this->Static.push_back({ (this->From.Points[v] - x).norm(), v });
    }
  }
  std::sort(this->Static.begin(), this->Static.end());
  this->GatherBeyond(vertex, radius);
}

void SideFinder::GatherBeyond(Index vertex, double radius)
{
  this->Beyond.clear();
  if (this->Around.Together == nullptr)
  {
    return;
  }
  const Connectivity& whole = this->Around.Together->TheConnectivity;
  const auto patchAt = [&](const Connectivity& connectivity, Index v)
  { return whole.PatchOf[connectivity.TrianglesOfVertex[v][0]]; };
  const Index own = patchAt(this->Around.TheConnectivity, vertex);
  const Vec3& x = this->Around.TheMesh.Points[vertex];
  std::vector<NearVertex> others;
  // What is intact is no common vertex, and has the same number in the whole.
  for (Index v : this->Near.Gather(
         this->From.Points, whole, this->Around.Together->Apart.WholeOf[vertex], x, radius))
  {
    if (!this->From.Region[v] && patchAt(whole, v) != own)
    {
      others.push_back({ (this->From.Points[v] - x).norm(), v });
    }
  }
  std::sort(others.begin(), others.end());
  std::vector<Index> pieces;
  for (const NearVertex& near : others)
  {
    const Index piece = this->From.ThePatches.PieceOf[near.Vertex];
    const auto known = std::find(pieces.begin(), pieces.end(), piece);
    const std::size_t place = static_cast<std::size_t>(known - pieces.begin());
    if (known == pieces.end())
    {
      pieces.push_back(piece);
      this->Beyond.emplace_back();
    }
    this->Beyond[place].push_back(near);
  }
}

SideFinder::FitWindow SideFinder::WindowFrom(double nearest, double scale) const
{
  const double roughness = this->Around.Rough.Degree;
  const double uncertain = Mixed(UnblurredDistance, RoughUnblurredDistance, roughness);
  const double distance = std::max(nearest, uncertain * this->From.BlurWidth * scale);
  return { distance + Mixed(SampleDepth, RoughSampleDepth, roughness) * scale,
    distance + Mixed(WeightDepth, RoughWeightDepth, roughness) * scale };
}

SheetSample SideFinder::SampleAt(const NearVertex& near, double width) const
{
  const IndexSpan neighbors = this->Around.TheConnectivity.NeighborsOfVertex[near.Vertex];
  const bool border = std::any_of(
    neighbors.begin(), neighbors.end(), [this](Index n) { return this->From.Region[n] != 0; });
  const double borderWeight = Mixed(BorderWeight, BlendedBorderWeight, this->Around.Rounding);
  const double d = near.Distance / width;
  const double weight = std::exp(-2.0 * d * d - this->From.Flatness[near.Vertex] / FlatnessScale) *
    (border ? borderWeight : 1.0);
  return { this->From.Points[near.Vertex], this->From.Normals[near.Vertex], weight };
}

void SideFinder::Fit(Index vertex, Side& side)
{
  const double scale = this->Around.Scales[vertex];
  const double roughness = this->Around.Rough.Degree;
  const FitWindow window = this->WindowFrom(side.Distance, scale);
  const double likeCosine = std::cos(LikeNormal * Pi / 180.0);
  const double widerCosine = std::cos(WiderNormal * Pi / 180.0);
  Vec3 normal = Vec3::Zero();
  Index piece = NoIndex;
  this->Fitted.clear();
  this->Wider.clear();
  for (const NearVertex& near : this->Static)
  {
    if (near.Distance > window.Radius)
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
    const double cosine = piece != NoIndex && this->From.ThePatches.PieceOf[v] == piece
      ? this->From.Normals[v].dot(normal)
      : -1.0;
    if (own || cosine >= likeCosine)
    {
      this->Fitted.push_back(this->SampleAt(near, window.Width));
    }
    else if (cosine >= widerCosine)
    {
      this->Wider.push_back(this->SampleAt(near, window.Width));
    }
  }
  SheetCaution caution;
  caution.CurvedGain =
    Mixed(caution.CurvedGain, BlendedCurvedGain, this->Around.Rounding * (1.0 - roughness));
  caution.FlatResidual = Mixed(caution.FlatResidual, RoughFlatResidual, roughness);
  caution.Ridge = Mixed(caution.Ridge, RoughRidge, roughness);
  side.Surface = Sheet(this->Fitted, scale, caution);
  if (this->Beyond.empty())
  {
    this->FitWider(scale, caution, side.Surface);
  }
  else
  {
    this->FitBeyond(scale, caution, side.Surface);
  }
  side.Surface.Unblur(this->From.BlurWidth * scale);
}

void SideFinder::FitWider(double scale, const SheetCaution& caution, Sheet& own)
{
  if (this->Wider.empty())
  {
    return;
  }
  const std::size_t before = this->Fitted.size();
  const double misfit = MisfitOf(own, this->Fitted, 0, before);
  this->Fitted.insert(this->Fitted.end(), this->Wider.begin(), this->Wider.end());
  const Sheet both(this->Fitted, scale, caution);
  const double most =
    std::max(std::max(OneFace, OfInterpolation * both.Curvature()) * scale, OneFaceGrowth * misfit);
  if (both.Curvature() * SampleDepth > LikeNormal * Pi / 180.0 &&
    SuitsBoth(both, this->Fitted, before, most))
  {
    own = both;
  }
  else
  {
    this->Fitted.resize(before);
  }
}

void SideFinder::FitBeyond(double scale, const SheetCaution& caution, Sheet& own) const
{
  std::vector<SheetSample> samples = this->Fitted;
  const double most =
    std::max(OneFace * scale, OneFaceGrowth * MisfitOf(own, samples, 0, samples.size()));
  const double likeCosine = std::cos(LikeNormal * Pi / 180.0);
  for (const std::vector<NearVertex>& piece : this->Beyond)
  {
    // From its nearest on, however far that is: what goes on over a narrow patch is worth most.
    const FitWindow window = this->WindowFrom(piece.front().Distance, scale);
    const std::size_t before = samples.size();
    for (const NearVertex& near : piece)
    {
      if (near.Distance > window.Radius)
      {
        break;
      }
      SheetSample sample = this->SampleAt(near, window.Width);
      const double cosine = sample.Normal.dot(own.Normal(sample.Position));
      if (std::abs(cosine) >= likeCosine) // patches may look either way
      {
        sample.Normal = cosine < 0.0 ? Vec3(-sample.Normal) : sample.Normal;
        samples.push_back(sample);
      }
    }
    if (samples.size() == before)
    {
      continue;
    }
    const Sheet both(samples, scale, caution);
    if (SuitsBoth(both, samples, before, most))
    {
      own = both;
    }
    else
    {
      samples.resize(before);
    }
  }
}
}
