// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Retreat.h"

#include "Core/Flagged.h"
#include "Core/Intersections.h"
#include "Core/TriangleCrossing.h"
#include "Overturned.h"

namespace arris
{
namespace
{
/// A triangle under this quality is folded over against its face, or as good as without area.
constexpr double FoldedQuality = 1e-4;

/// How often a vertex is taken back a part of its way only; so there is an end to it.
constexpr int MostSteps = 6;

class Guard
{
public:
  /// Of these triangles.
  Guard(const Mesh& mesh, const Connectivity& connectivity, const std::vector<Index>& triangles,
    Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , ThePlacement(placement)
    , Labelled(Those(triangles,
        [&](Index t) { return placement.LabelOf(t) != NoIndex || this->Moved(mesh.Triangles[t]); }))
    , StepsBack(connectivity.PatchOf.empty() ? 0 : mesh.Points.size(), 0)
  {
  }

  void Run()
  {
    this->UndoFolds(this->Labelled);
    this->UndoCuts(
      Those(this->Labelled, [this](Index t) { return this->Moved(this->TheMesh.Triangles[t]); }));
  }

  void TurnBack()
  {
    this->MayOverturn = false;
    std::vector<Index> changed;
    this->UndoFolds(
      Those(this->Labelled, [this](Index t) { return this->Overturned(t); }), &changed);
    this->UndoCuts(TrianglesAround(this->TheConnectivity, changed));
  }

private:
  void UndoCuts(std::vector<Index> suspects)
  {
    // Every round takes back at least one vertex for each pair, so there is an end to it.
    for (;;)
    {
      const std::vector<std::array<Index, 2>> cutting = FindIntersections(this->Now(), suspects);
      std::vector<Index> changed;
      for (const std::array<Index, 2>& pair : cutting)
      {
        this->Part(pair, changed);
      }
      if (changed.empty())
      {
        return;
      }
      this->UndoFolds(TrianglesAround(this->TheConnectivity, changed), &changed);
      suspects = TrianglesAround(
        this->TheConnectivity, changed); // only these can cut what they did not before
    }
  }

  MeshView Now() const { return { this->ThePlacement.AllPoints(), this->TheMesh.Triangles }; }

  bool Moved(Index v) const { return this->ThePlacement.PointOf(v) != this->TheMesh.Points[v]; }

  bool Moved(const Triangle& corners) const
  {
    return this->Moved(corners[0]) || this->Moved(corners[1]) || this->Moved(corners[2]);
  }

  bool Folded(Index t) const
  {
    return this->Moved(this->TheMesh.Triangles[t]) &&
      (this->ThePlacement.Quality(t) < FoldedQuality ||
        (!this->MayOverturn && this->Overturned(t)));
  }

  bool Overturned(Index t) const
  {
    return IsOverturned(this->TheMesh, this->TheConnectivity, this->ThePlacement.AllPoints(), t);
  }

  /// Of the triangles that move with a vertex, and those behind them.
  int FoldedAround(Index v) const
  {
    int folded = 0;
    for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
    {
      const int opposite = Next(CornerOf(this->TheMesh.Triangles[t], v));
      const Index beyond = this->TheConnectivity.AcrossEdge[t][opposite];
      folded += (this->Folded(t) ? 1 : 0) + (beyond != NoIndex && this->Folded(beyond) ? 1 : 0);
    }
    return folded;
  }

  /// Adds what it has changed to `allChanged`.
  void UndoFolds(std::vector<Index> suspects, std::vector<Index>* allChanged = nullptr)
  {
    std::vector<Index> changed;
    while (!suspects.empty())
    {
      changed.clear();
      for (Index t : suspects)
      {
        if (this->Folded(t) && !this->UndoOne(t, changed))
        {
          this->GiveBack(t, changed);
        }
      }
      suspects = TrianglesAround(this->TheConnectivity, changed);
      if (allChanged != nullptr)
      {
        allChanged->insert(allChanged->end(), changed.begin(), changed.end());
      }
    }
  }

  /// Takes one corner back, no farther than needed, if that mends more than it spoils.
  bool UndoOne(Index t, std::vector<Index>& changed)
  {
    Index best = NoIndex;
    int bestGain = 0;
    Vec3 bestPoint = Vec3::Zero();
    for (Index v : this->TheMesh.Triangles[t])
    {
      if (!this->Moved(v))
      {
        continue;
      }
      const Vec3 moved = this->ThePlacement.PointOf(v);
      const int before = this->FoldedAround(v);
      for (const double kept : { 0.8, 0.6, 0.4, 0.2, 0.0 })
      {
        const Vec3 point = kept * moved + (1.0 - kept) * this->TheMesh.Points[v];
        this->ThePlacement.SetPoint(v, kept > 0.0 ? point : this->TheMesh.Points[v]);
        const int gain = before - this->FoldedAround(v);
        if (gain > bestGain)
        {
          bestGain = gain;
          best = v;
          bestPoint = this->ThePlacement.PointOf(v);
        }
      }
      this->ThePlacement.SetPoint(v, moved);
    }
    if (best != NoIndex)
    {
      this->ThePlacement.SetPoint(best, bestPoint);
      changed.push_back(best);
    }
    return best != NoIndex;
  }

  void GiveBack(Index t, std::vector<Index>& changed)
  {
    for (Index v : this->TheMesh.Triangles[t])
    {
      if (this->Moved(v))
      {
        this->ThePlacement.SetPoint(v, this->TheMesh.Points[v]);
        changed.push_back(v);
      }
    }
  }

  /// Takes back what makes two triangles cut each other.
  void Part(const std::array<Index, 2>& pair, std::vector<Index>& changed)
  {
    if (!AreOnePatch(this->TheConnectivity, pair[0], pair[1]))
    {
      if (!CutThrough(this->Now(), pair[0], pair[1]) || this->PartPatches(pair, changed))
      {
        return;
      }
    }
    for (Index t : pair)
    {
      this->GiveBack(t, changed);
    }
  }

  /// Takes one vertex back, no farther than needed: where patches meet they are near each other all
  /// along, and cut each other by a little.
  bool PartPatches(const std::array<Index, 2>& pair, std::vector<Index>& changed)
  {
    for (const double kept : { 0.9, 0.75, 0.5, 0.25, 0.0 })
    {
      for (Index t : pair)
      {
        for (Index v : this->TheMesh.Triangles[t])
        {
          if (this->TakeBack(v, kept, pair))
          {
            changed.push_back(v);
            return true;
          }
        }
      }
    }
    return false;
  }

  /// Takes a vertex back to a part of its way, if then the triangles do not cut each other, and
  /// nothing folds that did not.
  bool TakeBack(Index v, double kept, const std::array<Index, 2>& pair)
  {
    if (!this->Moved(v) || (kept > 0.0 && this->StepsBack[v] == MostSteps))
    {
      return false;
    }
    const Vec3 before = this->ThePlacement.PointOf(v);
    const int folded = this->FoldedAround(v);
    const Vec3& from = this->TheMesh.Points[v];
    this->ThePlacement.SetPoint(v, kept > 0.0 ? Vec3(kept * before + (1.0 - kept) * from) : from);
    if (CutThrough(this->Now(), pair[0], pair[1]) || this->FoldedAround(v) > folded)
    {
      this->ThePlacement.SetPoint(v, before);
      return false;
    }
    ++this->StepsBack[v];
    return true;
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  Placement& ThePlacement;
  bool MayOverturn = true;
  std::vector<Index> Labelled;
  std::vector<int> StepsBack; // that each vertex has gone where patches cut each other
};
}

void Retreat(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Index>& triangles, Placement& placement)
{
  Guard(mesh, connectivity, triangles, placement).Run();
}

void TurnBack(const Mesh& input, const Connectivity& connectivity,
  const std::vector<Index>& triangles, Placement& placement)
{
  Guard(input, connectivity, triangles, placement).TurnBack();
}
}
