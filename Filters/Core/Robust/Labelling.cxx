// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Labelling.h"

#include "Core/Flagged.h"
#include "Neighbourhoods.h"
#include "Unblurred.h"
#include "Unexplained.h"

#include <algorithm>
#include <iterator>

namespace arris
{
namespace
{
/// Of the progress, what the first fit takes; the second is of few vertices. All is fitted again
/// in each round where a blur is undone.
constexpr double FirstFit = 0.9;
constexpr double BlurredLabelled = 0.4;

/// Each round of undoing a blur takes out most of what the one before has left.
constexpr int UnblurringRounds = 4;

bool FitSides(const Surroundings& around, const Samples& samples,
  const std::vector<Index>& vertices, const Monitor& monitor, Labelling& labelling)
{
  const Rows groups = GroupIntoNeighbourhoods(around, vertices);
  const bool keepSolids = around.IsBlurred();
  const auto first = static_cast<Index>(labelling.Solids.size());
  labelling.Solids.resize(keepSolids ? first + groups.size() : 0);
  return ParallelFor(groups.size(), monitor,
    [&](Index begin, Index end)
    {
      SideFinder finder(around, samples);
      std::vector<std::vector<Side>*> sides;
      for (Index g = begin; g < end; ++g)
      {
        sides.clear();
        for (Index v : groups[g])
        {
          sides.push_back(&labelling.Sides[labelling.SidesOf[v]]);
          labelling.SolidOf[labelling.SidesOf[v]] = keepSolids ? first + g : NoIndex;
        }
        LocalSolid solid = finder.Find(groups[g], sides);
        if (keepSolids)
        {
          labelling.Solids[first + g] = std::move(solid);
        }
      }
    });
}

/// Fits the sides again, to what a blur has moved as well, and labels by them. The first sides are
/// off by what the blur has done to their samples.
bool LabelUnblurred(
  const Surroundings& around, const Samples& samples, const Monitor& monitor, Labelling& labelling)
{
  constexpr double Rounds = UnblurringRounds;
  const std::vector<Index> damaged = Flagged(samples.Region);
  for (int round = 0; round < UnblurringRounds; ++round)
  {
    const double width = BlurWidth(around, damaged, labelling);
    if (!(width > 0.0))
    {
      return true;
    }
    const Unblurred unblurred(around, samples, damaged, labelling, width);
    labelling.Solids.clear();
    const Monitor part = monitor.Part(round / Rounds, (round + 1) / Rounds);
    if (!FitSides(around, unblurred.ToFit(), damaged, part, labelling))
    {
      return false;
    }
    labelling.Labels = FloodLabels(around.TheConnectivity, samples.ThePatches, samples.Region,
      labelling.Sides, labelling.SidesOf);
  }
  return true;
}

std::vector<Index> Without(std::vector<Index> vertices, const Flags& left)
{
  const auto isLeft = [&](Index v) { return !left.empty() && left[v] != 0; };
  vertices.erase(std::remove_if(vertices.begin(), vertices.end(), isLeft), vertices.end());
  return vertices;
}

/// Those of the vertices, in ascending order, that are of no tip.
std::vector<Index> WithoutTips(const std::vector<Index>& vertices, const std::vector<Apex>& apexes)
{
  std::vector<Index> ofTips;
  for (const Apex& apex : apexes)
  {
    ofTips.insert(ofTips.end(), apex.Members.begin(), apex.Members.end());
  }
  std::sort(ofTips.begin(), ofTips.end());
  std::vector<Index> others;
  std::set_difference(
    vertices.begin(), vertices.end(), ofTips.begin(), ofTips.end(), std::back_inserter(others));
  return others;
}
}

void LabelTips(const std::vector<Apex>& apexes, Labelling& labelling)
{
  Index label = labelling.FirstApexLabel;
  for (const Apex& apex : apexes)
  {
    for (Index v : apex.Members)
    {
      labelling.Labels[v] = label;
      labelling.Sides[labelling.SidesOf[v]].clear();
    }
    ++label;
  }
}

bool LabelVertices(const Surroundings& around, const std::vector<Apex>& apexes,
  const Flags& unfitted, const Monitor& monitor, Flags& region, Labelling& labelling)
{
  Patches patches = SortIntoPatches(
    around.TheMesh, around.TheConnectivity, around.TheFaces, around.Flatness, region);
  const std::vector<Index> damaged = Flagged(region);
  labelling.SidesOf.assign(around.TheMesh.Points.size(), NoIndex);
  for (std::size_t i = 0; i < damaged.size(); ++i)
  {
    labelling.SidesOf[damaged[i]] = static_cast<Index>(i);
  }
  labelling.Sides.assign(damaged.size(), {});
  labelling.SolidOf.assign(damaged.size(), NoIndex);
  const Samples samples{ around.TheMesh.Points, around.TheFaces.VertexNormals, around.Flatness,
    region, patches, 0.0 };
  const double labelled = around.IsBlurred() ? BlurredLabelled : 1.0;
  const double fitted = FirstFit * labelled;
  const std::vector<Index> open = Without(damaged, unfitted);
  if (!FitSides(around, samples, open, monitor.Part(0.0, fitted), labelling))
  {
    return false;
  }

  const std::vector<Index> released =
    ReleaseUnexplained(around, WithoutTips(open, apexes), labelling, region);
  AddNarrowPatches(
    around.TheConnectivity, around.TheFaces, around.Flatness, region, released, patches);
  for (Index v : released)
  {
    labelling.SidesOf[v] = NoIndex;
  }
  const std::vector<Index> again = Without(DamagedNear(around, released, region), unfitted);
  if (!FitSides(around, samples, again, monitor.Part(fitted, labelled), labelling))
  {
    return false;
  }
  labelling.FirstApexLabel = patches.PatchCount;
  labelling.Labels =
    FloodLabels(around.TheConnectivity, patches, region, labelling.Sides, labelling.SidesOf);
  if (around.IsBlurred() &&
    !LabelUnblurred(around, samples, monitor.Part(labelled, 1.0), labelling))
  {
    return false;
  }
  LabelTips(apexes, labelling);
  return true;
}

const Side* Labelling::SideAt(Index vertex) const
{
  const Index row = this->SidesOf[vertex];
  return row != NoIndex ? FindSide(this->Sides[row], this->Labels[vertex]) : nullptr;
}

const LocalSolid* Labelling::SolidAt(Index vertex) const
{
  const Index row = this->SidesOf[vertex];
  return row != NoIndex && this->Sides[row].size() > 1 ? &this->Solids[this->SolidOf[row]]
                                                       : nullptr;
}

const Sheet* Labelling::SheetAt(const Connectivity& connectivity, Index vertex, Index label) const
{
  if (this->SidesOf[vertex] != NoIndex)
  {
    if (const Side* side = FindSide(this->Sides[this->SidesOf[vertex]], label))
    {
      return &side->Surface;
    }
  }
  for (Index n : connectivity.NeighborsOfVertex[vertex])
  {
    if (this->SidesOf[n] != NoIndex)
    {
      if (const Side* side = FindSide(this->Sides[this->SidesOf[n]], label))
      {
        return &side->Surface;
      }
    }
  }
  return nullptr;
}
}
