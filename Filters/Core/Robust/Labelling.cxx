// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Labelling.h"

#include "Core/Flagged.h"
#include "Neighbourhoods.h"
#include "Unexplained.h"

namespace arris
{
namespace
{
/// Of the progress, what the first fit takes; the second is of few vertices.
constexpr double FirstFit = 0.9;

bool FitSides(const Surroundings& around, const Flags& region, const Patches& patches,
  const std::vector<Index>& vertices, const Monitor& monitor, Labelling& labelling)
{
  const Rows groups = GroupIntoNeighbourhoods(around, vertices);
  return ParallelFor(groups.size(), monitor,
    [&](Index begin, Index end)
    {
      SideFinder finder(around, region, patches);
      std::vector<std::vector<Side>*> sides;
      for (Index g = begin; g < end; ++g)
      {
        sides.clear();
        for (Index v : groups[g])
        {
          sides.push_back(&labelling.Sides[labelling.SidesOf[v]]);
        }
        finder.Find(groups[g], sides);
      }
    });
}
}

bool LabelVertices(
  const Surroundings& around, const Monitor& monitor, Flags& region, Labelling& labelling)
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
  if (!FitSides(around, region, patches, damaged, monitor.Part(0.0, FirstFit), labelling))
  {
    return false;
  }

  const std::vector<Index> released = ReleaseUnexplained(around, damaged, labelling, region);
  AddNarrowPatches(
    around.TheConnectivity, around.TheFaces, around.Flatness, region, released, patches);
  for (Index v : released)
  {
    labelling.SidesOf[v] = NoIndex;
  }
  const std::vector<Index> again = DamagedNear(around, released, region);
  if (!FitSides(around, region, patches, again, monitor.Part(FirstFit, 1.0), labelling))
  {
    return false;
  }
  labelling.FirstApexLabel = patches.PatchCount;
  labelling.Labels =
    FloodLabels(around.TheConnectivity, patches, region, labelling.Sides, labelling.SidesOf);
  return true;
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
