// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Unblurred.h"

#include "Mixed.h"
#include "Spread.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace arris
{
namespace
{
// In widths of the blur.
constexpr double Reach = 5.0; // an acute edge's blur still moves what is this far beyond the region
constexpr double MostCorrection = 0.15; // more is known too badly to be fitted to
constexpr double CorrectionScale = 0.05; // at which a sample's weight falls to 1/e

// The same where roughness spoils what is farther from the edge as much.
constexpr double RoughMostCorrection = 0.6;
constexpr double RoughCorrectionScale = 0.2;

// A vertex outside the region is explained by the solid near it if it lies on its surface (in local
// scales) and faces like it (the cosine).
constexpr double OnSurface = 0.1;
constexpr double LikeCosine = 0.9;

/// For each vertex in or near the region the solid that it belongs to, by a walk from the region.
std::vector<const LocalSolid*> SolidsNear(const Surroundings& around, const Flags& region,
  const std::vector<Index>& damaged, const Labelling& labelling, double reach)
{
  std::vector<Index> sources;
  std::copy_if(damaged.begin(), damaged.end(), std::back_inserter(sources),
    [&](Index v) { return labelling.SolidAt(v) != nullptr; });
  const Walk walk = WalkFrom(sources, reach, around.TheMesh, around.TheConnectivity, around.Scales,
    [&](Index v) { return region[v] == 0; });
  std::vector<const LocalSolid*> solids(region.size(), nullptr);
  for (Index v : walk.Reached)
  {
    solids[v] = labelling.SolidAt(walk.OriginOf[v]);
  }
  return solids;
}
}

double BlurWidth(
  const Surroundings& around, const std::vector<Index>& damaged, const Labelling& labelling)
{
  constexpr double Most = 2.5; // in local scales; wider blurs leave no edge to be found
  constexpr double Step = 0.1; // what is left is flat about its least
  constexpr std::size_t MostProbes = 1000;
  constexpr double Outlier = 0.3; // farther off than this, in local scales, is as bad as any
  const std::size_t stride = damaged.size() / MostProbes + 1;
  double best = 0.0, least = 1e300;
  for (int k = 0; k * Step <= Most; ++k)
  {
    double left = 0.0;
    for (std::size_t i = 0; i < damaged.size(); i += stride)
    {
      const Index v = damaged[i];
      if (const LocalSolid* solid = labelling.SolidAt(v))
      {
        const double scale = around.Scales[v];
        const double off = solid->BlurredValue(around.TheMesh.Points[v], k * Step * scale).Distance;
        left += std::min(std::abs(off) / scale, Outlier);
      }
    }
    if (left < least)
    {
      least = left;
      best = k * Step;
    }
  }
  return best;
}

Unblurred::Unblurred(const Surroundings& around, const Samples& blurred,
  const std::vector<Index>& damaged, const Labelling& labelling, double width)
  : Points(blurred.Points)
  , Normals(blurred.Normals)
  , Flatness(blurred.Flatness)
  , Region(blurred.Region)
  , ThePatches(blurred.ThePatches)
  , Width(width)
{
  const double mostCorrection = Mixed(MostCorrection, RoughMostCorrection, around.Rough.Degree);
  const double correctionScale = Mixed(CorrectionScale, RoughCorrectionScale, around.Rough.Degree);
  const Patches& patches = blurred.ThePatches;
  std::vector<Index> pieceOfPatch(patches.PatchCount, NoIndex);
  for (std::size_t v = 0; v < patches.PatchOf.size(); ++v)
  {
    if (patches.PatchOf[v] != NoIndex)
    {
      pieceOfPatch[patches.PatchOf[v]] = patches.PieceOf[v];
    }
  }
  const std::vector<const LocalSolid*> solids =
    SolidsNear(around, blurred.Region, damaged, labelling, Reach * width);
  for (std::size_t v = 0; v < solids.size(); ++v)
  {
    if (solids[v] == nullptr)
    {
      continue;
    }
    const Vec3& x = blurred.Points[v];
    const double scale = around.Scales[v];
    const LocalSolid::Value sharp = solids[v]->SharpValue(x);
    const double off = solids[v]->BlurredValue(x, width * scale).Distance;
    const double correction = (off - sharp.Distance) / (width * scale);
    if (blurred.Region[v])
    {
      // It has to lie on the sheet that is active there.
      const Side* side = labelling.SideAt(static_cast<Index>(v));
      if (side == nullptr || side->Surface.Distance(x) != sharp.Distance ||
        std::abs(correction) > mostCorrection)
      {
        continue;
      }
      this->Region[v] = 0;
      this->ThePatches.PatchOf[v] = side->Patch;
      this->ThePatches.PieceOf[v] = pieceOfPatch[side->Patch];
      this->Normals[v] = sharp.Normal;
    }
    else if (std::abs(off) > OnSurface * scale || sharp.Normal.dot(blurred.Normals[v]) < LikeCosine)
    {
      continue;
    }
    this->Points[v] = x + (off - sharp.Distance) * sharp.Normal;
    const double distrust = correction / correctionScale;
    this->Flatness[v] = FlatnessScale * distrust * distrust;
  }
}
}
