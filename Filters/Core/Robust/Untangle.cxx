// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Untangle.h"

#include "Core/Geometry.h"
#include "Core/SortUnique.h"
#include "Overturned.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace arris
{
namespace
{
/// Triangles under this quality are mended.
constexpr double BadQuality = 0.01;

/// A change that gains less is one of rounding.
constexpr double LeastGain = 1e-6;

/// What has not been mended in so many rounds will not be, and others make way for it all the time.
constexpr int MostTries = 6;
constexpr int RoundsAlone = 2;

/// Vertices with more triangles than any sampling makes are not worked on: their fans come from
/// tessellation, and trying all moves there would take the square of their size.
constexpr Index LargestFan = 32;

class Untangler
{
public:
  Untangler(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales,
    Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , Scales(scales)
    , ThePlacement(placement)
    , Tries(mesh.Triangles.size(), 0)
  {
  }

  void Run()
  {
    std::vector<Index> suspects;
    for (Index t = 0; t < this->TheMesh.TriangleCount(); ++t)
    {
      if (this->ThePlacement.LabelOf(t) != NoIndex)
      {
        suspects.push_back(t);
      }
    }
    for (int round = 0; !suspects.empty(); ++round)
    {
      this->Touched.clear();
      const std::vector<Index> bad = this->TryAgain(this->BadAmong(suspects));
      // What single vertices could not mend in a few rounds may want room made by the ones around.
      const bool stuck = round >= RoundsAlone;
      for (Index v : stuck ? this->VerticesOf(this->TrianglesAround(this->VerticesOf(bad)))
                           : this->VerticesOf(bad))
      {
        this->Slide(v);
      }
      for (Index t : this->BadAmong(bad))
      {
        this->Relabel(t);
      }
      suspects = this->TrianglesAround(this->Touched);
    }
  }

private:
  /// Those of the triangles that have not been tried too often yet.
  std::vector<Index> TryAgain(const std::vector<Index>& bad)
  {
    std::vector<Index> again;
    std::copy_if(bad.begin(), bad.end(), std::back_inserter(again),
      [this](Index t) { return this->Tries[t]++ < MostTries; });
    return again;
  }

  std::vector<Index> BadAmong(const std::vector<Index>& triangles) const
  {
    std::vector<Index> bad;
    for (Index t : triangles)
    {
      if (this->ThePlacement.LabelOf(t) != NoIndex &&
        (this->ThePlacement.Quality(t) < BadQuality || this->IsOver(t)))
      {
        bad.push_back(t);
      }
    }
    return bad;
  }

  std::vector<Index> VerticesOf(const std::vector<Index>& triangles) const
  {
    std::vector<Index> vertices;
    for (Index t : triangles)
    {
      for (Index v : this->TheMesh.Triangles[t])
      {
        if (this->ThePlacement.IsDamaged(v))
        {
          vertices.push_back(v);
        }
      }
    }
    SortUnique(vertices);
    return vertices;
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

  bool IsOver(Index t) const
  {
    return IsOverturned(this->TheMesh, this->TheConnectivity, this->ThePlacement.AllPoints(), t);
  }

  /// What triangles are worth; those that are good enough count alike, and to have one turned over
  /// is worse than any shape. What is worth no more than `least` is not looked at to its end.
  double Worth(IndexSpan triangles, double least = -std::numeric_limits<double>::infinity()) const
  {
    double worth = 0.0;
    double possible = this->MostWorth(triangles);
    for (Index t : triangles)
    {
      const double quality = std::min(this->ThePlacement.Quality(t), GoodEnoughQuality);
      worth += quality;
      possible += quality - GoodEnoughQuality;
      if (possible > least && this->IsOver(t))
      {
        worth -= 1.0;
        possible -= 1.0;
      }
      if (possible <= least)
      {
        return possible;
      }
    }
    return worth;
  }

  static double MostWorth(IndexSpan triangles) { return GoodEnoughQuality * triangles.size(); }

  double Worth(const std::vector<Index>& triangles) const
  {
    return this->Worth(IndexSpan(triangles.data(), triangles.data() + triangles.size()));
  }

  void Slide(Index v)
  {
    const std::vector<const Sheet*>& sheets = this->ThePlacement.SheetsOf(v);
    Vec3 along = Vec3::Zero();
    const int freedom = this->ThePlacement.Freedom(v, along);
    if (freedom == 0 || this->TheConnectivity.TrianglesOfVertex[v].size() > LargestFan)
    {
      return;
    }
    const Vec3 start = this->ThePlacement.PointOf(v);
    const IndexSpan around = this->TheConnectivity.TrianglesOfVertex[v];
    Vec3 best = start;
    double bestWorth = this->Worth(around) + LeastGain;
    const double mostWorth = this->MostWorth(around);
    const auto attempt = [&](const Vec3& target)
    {
      if (bestWorth > mostWorth - LeastGain)
      {
        return;
      }
      const Vec3 point = this->ThePlacement.Held(v, target);
      this->ThePlacement.SetPoint(v, point);
      const double worth = this->Worth(around, bestWorth);
      this->ThePlacement.SetPoint(v, start);
      if (worth > bestWorth)
      {
        bestWorth = worth;
        best = point;
      }
    };
    Vec3 center = Vec3::Zero();
    const IndexSpan neighbors = this->TheConnectivity.NeighborsOfVertex[v];
    for (Index n : neighbors)
    {
      center += this->ThePlacement.PointOf(n);
    }
    center /= neighbors.size();
    attempt(center);
    attempt(0.5 * (center + start));
    const Vec3 normal = sheets[0]->Normal(start);
    for (const double step : { 0.05, 0.15, 0.4, 0.8 })
    {
      const double length = step * this->Scales[v];
      if (freedom == 1)
      {
        attempt(start + length * along);
        attempt(start - length * along);
        continue;
      }
      const Vec3 u = normal.unitOrthogonal();
      const Vec3 w = normal.cross(u);
      for (int k = 0; k < 8; ++k)
      {
        const double angle = k * Pi / 4.0;
        attempt(start + length * (std::cos(angle) * u + std::sin(angle) * w));
      }
    }
    if (best != start)
    {
      this->ThePlacement.SetPoint(v, best);
      this->Touched.push_back(v);
    }
  }

  /// The triangles of a fan around `v` that bear one label.
  std::vector<Index> Sector(Index v, Index label) const
  {
    std::vector<Index> sector;
    for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
    {
      if (this->ThePlacement.LabelOf(t) == label)
      {
        sector.push_back(t);
      }
    }
    return sector;
  }

  bool OnRidge(Index v) const
  {
    return this->ThePlacement.IsDamaged(v) && this->ThePlacement.SheetsOf(v).size() > 1;
  }

  /// The triangles of one label that are shut in with `bad` between edges of the ridge: where the
  /// ridge runs past a chord of itself, they have no room. Empty if there are too many for that.
  std::vector<Index> Pocket(Index bad) const
  {
    constexpr std::size_t Largest = 24;
    const Index label = this->ThePlacement.LabelOf(bad);
    std::vector<Index> pocket(1, bad);
    for (std::size_t next = 0; next < pocket.size(); ++next)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Triangle& corners = this->TheMesh.Triangles[pocket[next]];
        const Index beyond = this->TheConnectivity.AcrossEdge[pocket[next]][k];
        if (beyond == NoIndex || this->ThePlacement.LabelOf(beyond) != label ||
          (this->OnRidge(corners[k]) && this->OnRidge(corners[Next(k)])) ||
          std::find(pocket.begin(), pocket.end(), beyond) != pocket.end())
        {
          continue;
        }
        if (pocket.size() == Largest)
        {
          return {};
        }
        pocket.push_back(beyond);
      }
    }
    return pocket;
  }

  /// Gives the triangle, or with it what bears its label around one of its corners, to the face of
  /// one of its neighbours, if that is worth it.
  void Relabel(Index bad)
  {
    for (Index v : this->TheMesh.Triangles[bad])
    {
      if (this->TheConnectivity.TrianglesOfVertex[v].size() > LargestFan)
      {
        return;
      }
    }
    const Index own = this->ThePlacement.LabelOf(bad);
    std::vector<Index> labels;
    for (Index v : this->TheMesh.Triangles[bad])
    {
      for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
      {
        const Index label = this->ThePlacement.LabelOf(t);
        if (label != NoIndex && label != own && // labels stay within a patch
          AreOnePatch(this->TheConnectivity, t, bad))
        {
          labels.push_back(label);
        }
      }
    }
    SortUnique(labels);
    std::vector<std::vector<Index>> groups(1, std::vector<Index>(1, bad));
    for (Index v : this->TheMesh.Triangles[bad])
    {
      groups.push_back(this->Sector(v, own));
    }
    groups.push_back(this->Pocket(bad));
    double bestGain = LeastGain;
    Index bestLabel = NoIndex;
    const std::vector<Index>* bestGroup = nullptr;
    for (const std::vector<Index>& group : groups)
    {
      if (group.empty())
      {
        continue;
      }
      for (Index label : labels)
      {
        const double gain = this->GainOf(group, label);
        if (gain > bestGain)
        {
          bestGain = gain;
          bestLabel = label;
          bestGroup = &group;
        }
      }
    }
    if (bestGroup != nullptr)
    {
      const std::vector<Index> vertices = this->VerticesOf(*bestGroup);
      this->Apply(*bestGroup, bestLabel, vertices);
      this->Touched.insert(this->Touched.end(), vertices.begin(), vertices.end());
    }
  }

  void Apply(const std::vector<Index>& group, Index label, const std::vector<Index>& vertices)
  {
    for (Index t : group)
    {
      this->ThePlacement.SetLabel(t, label);
    }
    for (Index v : vertices)
    {
      this->ThePlacement.Place(v);
    }
    for (Index v : vertices)
    {
      this->Slide(v);
    }
  }

  /// What relabelling would gain; everything is put back.
  double GainOf(const std::vector<Index>& group, Index label)
  {
    for (Index t : group)
    {
      for (Index v : this->TheMesh.Triangles[t])
      {
        if (!this->ThePlacement.IsDamaged(v))
        {
          return 0.0; // an intact vertex stays on its own face
        }
      }
    }
    const std::vector<Index> vertices = this->VerticesOf(group);
    const std::vector<Index> triangles = this->TrianglesAround(vertices);
    const double before = this->Worth(triangles);
    std::vector<Vec3> points;
    points.reserve(vertices.size());
    for (Index v : vertices)
    {
      points.push_back(this->ThePlacement.PointOf(v));
    }
    const Index own = this->ThePlacement.LabelOf(group.front());
    this->Apply(group, label, vertices);
    const double gain = this->Worth(triangles) - before;
    for (Index t : group)
    {
      this->ThePlacement.SetLabel(t, own);
    }
    for (Index v : vertices)
    {
      this->ThePlacement.Place(v);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      this->ThePlacement.SetPoint(vertices[i], points[i]);
    }
    return gain;
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const std::vector<double>& Scales;
  Placement& ThePlacement;
  std::vector<int> Tries; // of each triangle
  std::vector<Index> Touched;
};
}

void Untangle(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales,
  Placement& placement)
{
  Untangler(mesh, connectivity, scales, placement).Run();
}
}
