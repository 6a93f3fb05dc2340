// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Retreat.h"

#include "Core/Intersections.h"
#include "Core/SortUnique.h"

#include <algorithm>
#include <iterator>

namespace arris
{
namespace
{
/// A triangle under this quality is folded over, or as good as without area.
constexpr double FoldedQuality = 1e-4;

class Guard
{
public:
  Guard(const Mesh& mesh, const Connectivity& connectivity, Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , ThePlacement(placement)
  {
    for (Index t = 0; t < mesh.TriangleCount(); ++t)
    {
      if (placement.LabelOf(t) != NoIndex || this->Moved(mesh.Triangles[t]))
      {
        this->Labelled.push_back(t);
      }
    }
  }

  void Run()
  {
    this->UndoFolds(this->Labelled);
    std::vector<Index> suspects;
    std::copy_if(this->Labelled.begin(), this->Labelled.end(), std::back_inserter(suspects),
      [this](Index t) { return this->Moved(this->TheMesh.Triangles[t]); });
    // Every round gives back at least one vertex for each pair, so there is an end to it.
    for (;;)
    {
      const std::vector<Index> cutting = this->CuttingTriangles(suspects);
      if (cutting.empty())
      {
        return;
      }
      std::vector<Index> changed;
      for (Index t : cutting)
      {
        this->GiveBack(t, changed);
      }
      this->UndoFolds(this->TrianglesAround(changed), &changed);
      suspects = this->TrianglesAround(changed); // only these can cut what they did not before
    }
  }

private:
  bool Moved(Index v) const { return this->ThePlacement.PointOf(v) != this->TheMesh.Points[v]; }

  bool Moved(const Triangle& corners) const
  {
    return this->Moved(corners[0]) || this->Moved(corners[1]) || this->Moved(corners[2]);
  }

  std::vector<Index> TrianglesAround(const std::vector<Index>& vertices) const
  {
    std::vector<Index> triangles;
    for (Index v : vertices)
    {
      for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
      {
        triangles.push_back(t);
      }
    }
    SortUnique(triangles);
    return triangles;
  }

  bool Folded(Index t) const
  {
    return this->Moved(this->TheMesh.Triangles[t]) && this->ThePlacement.Quality(t) < FoldedQuality;
  }

  int FoldedAround(Index v) const
  {
    const IndexSpan around = this->TheConnectivity.TrianglesOfVertex[v];
    return static_cast<int>(
      std::count_if(around.begin(), around.end(), [this](Index t) { return this->Folded(t); }));
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
      suspects = this->TrianglesAround(changed);
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

  /// Of the pairs with one of `suspects` that cut each other, the triangles that have moved.
  std::vector<Index> CuttingTriangles(const std::vector<Index>& suspects) const
  {
    Mesh moved;
    moved.Points = this->ThePlacement.AllPoints();
    moved.Triangles = this->TheMesh.Triangles;
    std::vector<Index> cutting;
    for (const auto& pair : FindIntersections(moved, suspects))
    {
      for (Index t : pair)
      {
        if (this->Moved(this->TheMesh.Triangles[t]))
        {
          cutting.push_back(t);
        }
      }
    }
    SortUnique(cutting);
    return cutting;
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  Placement& ThePlacement;
  std::vector<Index> Labelled;
};
}

void Retreat(const Mesh& mesh, const Connectivity& connectivity, Placement& placement)
{
  Guard(mesh, connectivity, placement).Run();
}
}
