// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FanWorth.h"

#include "Overturned.h"

#include <algorithm>

namespace arris
{
namespace
{
/// Shapes first, as they tell of most that it is worth too little.
template <typename Quality, typename IsOver>
double SumUp(Index count, double least, Quality&& quality, IsOver&& isOver)
{
  double worth = MostWorth(count);
  for (Index i = 0; i < count && worth > least; ++i)
  {
    worth += std::min(quality(i), GoodEnoughQuality) - GoodEnoughQuality;
  }
  for (Index i = 0; i < count && worth > least; ++i)
  {
    worth -= isOver(i) ? 1.0 : 0.0;
  }
  return worth;
}
}

double WorthOf(const Mesh& mesh, const Connectivity& connectivity, const Placement& placement,
  IndexSpan triangles, double least)
{
  return SumUp(
    triangles.size(), least, [&](Index i) { return placement.Quality(triangles[i]); },
    [&](Index i) { return IsOverturned(mesh, connectivity, placement.AllPoints(), triangles[i]); });
}

void FanWorth::Take(Index vertex)
{
  const IndexSpan around = this->TheConnectivity.TrianglesOfVertex[vertex];
  const std::vector<Vec3>& points = this->ThePlacement.AllPoints();
  this->Blades.clear();
  for (Index t : around)
  {
    Blade blade;
    blade.Triangle = t;
    blade.Surface = this->ThePlacement.SheetOf(t);
    blade.Before = Corners(this->TheMesh, t).AreaVector();
    blade.Other = blade.Before;
    blade.Known = false;
    for (int k = 0; k < 3; ++k)
    {
      const Index beyond = this->TheConnectivity.AcrossEdge[t][k];
      const Index* const at = std::find(around.begin(), around.end(), beyond);
      blade.Across[k] = at != around.end() ? static_cast<Index>(at - around.begin()) : NoIndex;
      blade.Beyond[k] = at == around.end() && beyond != NoIndex
        ? Corners(points, this->TheMesh.Triangles[beyond]).AreaVector()
        : Vec3(Vec3::Zero());
    }
    this->Blades.push_back(blade);
  }
}

double FanWorth::Now(double least)
{
  for (Blade& blade : this->Blades)
  {
    blade.Known = false;
  }
  return SumUp(
    static_cast<Index>(this->Blades.size()), least,
    [this](Index i) { return this->QualityOf(this->Blades[i]); },
    [this](Index i) { return this->IsOver(this->Blades[i]); });
}

double FanWorth::QualityOf(Blade& blade) const
{
  const Corners corners(this->ThePlacement.AllPoints(), this->TheMesh.Triangles[blade.Triangle]);
  const Vec3 expected =
    blade.Surface ? blade.Surface->Normal(corners.Centroid()) : Vec3(blade.Before.normalized());
  return ShapeQuality(corners, this->AreaOf(blade), expected);
}

const Vec3& FanWorth::AreaOf(Blade& blade) const
{
  if (!blade.Known)
  {
    blade.Area =
      Corners(this->ThePlacement.AllPoints(), this->TheMesh.Triangles[blade.Triangle]).AreaVector();
    blade.Known = true;
  }
  return blade.Area;
}

bool FanWorth::IsOver(Blade& blade)
{
  const Vec3& area = this->AreaOf(blade);
  for (int k = 0; k < 3; ++k)
  {
    const Vec3& beyond =
      blade.Across[k] != NoIndex ? this->AreaOf(this->Blades[blade.Across[k]]) : blade.Beyond[k];
    if (AreFolded(area, beyond) &&
      MayFold(this->TheMesh, this->TheConnectivity, blade.Triangle,
        this->TheConnectivity.AcrossEdge[blade.Triangle][k]))
    {
      return true;
    }
  }
  return area.dot(blade.Before) < 0.0 && area.dot(blade.Other) < 0.0 &&
    FacesAgainstAll(this->TheMesh, this->TheConnectivity, area, blade.Triangle, blade.Other);
}
}
