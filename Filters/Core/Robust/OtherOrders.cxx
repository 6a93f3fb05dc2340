// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OtherOrders.h"

#include "Core/Flagged.h"
#include "Creases.h"
#include "Overturned.h"
#include "Retreat.h"
#include "Straighten.h"
#include "Untangle.h"

#include <algorithm>

namespace arris
{
namespace
{
/// Each more order helps less than the one before.
constexpr int Orders = 4;

/// How many edges around what was moved are mended again: as far as relabelling reaches.
constexpr int SpotRings = 2;

class Attempts
{
public:
  Attempts(const Labelled& mesh, const Placement& placed, const std::vector<Index>& tangled,
    Placement& placement, std::vector<Vec3>& wanted)
    : TheMesh(mesh)
    , Placed(placed)
    , Best(placement)
    , BestWanted(wanted)
    , InSpot(mesh.Region.size(), 0)
  {
    Flags seeds(mesh.Region.size(), 0);
    for (Index v : tangled)
    {
      seeds[v] = 1;
    }
    const std::vector<int> away = EdgesAwayFrom(mesh.TheConnectivity, seeds, SpotRings);
    for (std::size_t v = 0; v < away.size(); ++v)
    {
      this->InSpot[v] = away[v] >= 0 && placement.IsDamaged(static_cast<Index>(v)) ? 1 : 0;
    }
    this->Spots = Flagged(this->InSpot);
    this->Triangles = TrianglesAround(mesh.TheConnectivity, this->Spots);
  }

  void Run()
  {
    std::vector<Index> taken;
    for (int order = 1; order < Orders && !this->Spots.empty(); ++order)
    {
      Placement attempt = this->Best;
      this->StartAgain(attempt);
      const Labelled& mesh = this->TheMesh;
      Untangle(mesh.Now, mesh.TheConnectivity, mesh.Scales, this->Triangles, order, attempt);
      Straighten(
        mesh.Now, mesh.TheConnectivity, mesh.Labels, mesh.Before.Points, this->Spots, attempt);
      const std::vector<Vec3> wanted = attempt.AllPoints();
      Retreat(mesh.Safe, mesh.TheConnectivity,
        TrianglesAround(mesh.TheConnectivity, Flagged(this->DifferencesOf(attempt))), attempt);
      this->TakeTheBetter(attempt, wanted, taken);
    }
    // Each attempt cuts nothing, but two beside each other may be of different ones.
    Retreat(this->TheMesh.Safe, this->TheMesh.TheConnectivity,
      TrianglesAround(this->TheMesh.TheConnectivity, taken), this->Best);
  }

private:
  /// Undoes what mending has done in the spots.
  void StartAgain(Placement& attempt) const
  {
    for (Index v : this->Spots)
    {
      attempt.TakeVertex(v, this->Placed);
    }
    for (Index t : this->Triangles)
    {
      const Triangle& corners = this->TheMesh.Now.Triangles[t];
      const bool inside = std::all_of(corners.begin(), corners.end(),
        [&](Index v) { return this->InSpot[v] || !attempt.IsDamaged(v); });
      if (inside)
      {
        attempt.SetLabel(t, this->Placed.LabelOf(t));
      }
    }
  }

  Flags DifferencesOf(const Placement& attempt) const
  {
    Flags differs(this->InSpot.size());
    for (Index v = 0; v < static_cast<Index>(differs.size()); ++v)
    {
      differs[v] = attempt.PointOf(v) != this->Best.PointOf(v) ? 1 : 0;
    }
    return differs;
  }

  void TakeTheBetter(
    const Placement& attempt, const std::vector<Vec3>& wanted, std::vector<Index>& taken)
  {
    std::vector<Index> better;
    ForEachGroup(this->TheMesh.TheConnectivity, this->DifferencesOf(attempt), 1,
      [&](const std::vector<Index>& spot)
      {
        if (this->IsBetter(attempt, wanted, spot))
        {
          better.insert(better.end(), spot.begin(), spot.end());
        }
      });
    for (Index v : better)
    {
      this->Best.TakeVertex(v, attempt);
      this->BestWanted[v] = wanted[v];
    }
    for (Index t : TrianglesAround(this->TheMesh.TheConnectivity, better))
    {
      this->Best.SetLabel(t, attempt.LabelOf(t));
    }
    taken.insert(taken.end(), better.begin(), better.end());
  }

  /// Fewer creases, but not because a corner is cut off, or triangles are turned over, which would
  /// go back in the end.
  bool IsBetter(
    const Placement& attempt, const std::vector<Vec3>& wanted, const std::vector<Index>& spot) const
  {
    int corners = 0;
    double creases = 0.0;
    for (Index v : spot)
    {
      corners += (IsCorner(attempt, wanted, v) ? 1 : 0) -
        (IsCorner(this->Best, this->BestWanted, v) ? 1 : 0);
      creases += this->CreasesAt(attempt, v) - this->CreasesAt(this->Best, v);
    }
    return corners >= 0 && creases < 0.0 &&
      this->OverturnedAround(attempt, spot) <= this->OverturnedAround(this->Best, spot);
  }

  int OverturnedAround(const Placement& placement, const std::vector<Index>& spot) const
  {
    const Labelled& mesh = this->TheMesh;
    const std::vector<Index> around = TrianglesAround(mesh.TheConnectivity, spot);
    return static_cast<int>(std::count_if(around.begin(), around.end(),
      [&](Index t)
      { return IsOverturned(mesh.Before, mesh.TheConnectivity, placement.AllPoints(), t); }));
  }

  static bool IsCorner(const Placement& placement, const std::vector<Vec3>& wanted, Index v)
  {
    return placement.IsDamaged(v) && placement.SheetsOf(v).size() > 2 && !placement.IsOnCurve(v) &&
      placement.PointOf(v) == wanted[v];
  }

  double CreasesAt(const Placement& placement, Index v) const
  {
    return CreasesAround(
      this->TheMesh.Now.Triangles, this->TheMesh.TheConnectivity, placement.AllPoints(), v);
  }

  const Labelled& TheMesh;
  const Placement& Placed;
  Placement& Best;
  std::vector<Vec3>& BestWanted;
  Flags InSpot;
  std::vector<Index> Spots;
  std::vector<Index> Triangles; ///< around them
};
}

void TryOtherOrders(const Labelled& mesh, const Placement& placed,
  const std::vector<Index>& tangled, Placement& placement, std::vector<Vec3>& wanted)
{
  Attempts(mesh, placed, tangled, placement, wanted).Run();
}
}
