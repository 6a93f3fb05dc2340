// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Ears.h"

#include "Core/Geometry.h"

#include <algorithm>

namespace arris
{
namespace
{
// Lengths in local scales.
constexpr double LeastHeight = 0.02; // what an ear is given: enough not to be called folded
constexpr double MostLift = 0.1; // of one vertex; more would show

/// Under this quality an ear is lifted: what `LeastHeight` gives to one of common size.
constexpr double FlatQuality = 0.01;

/// Ears on ears: each needs the one below lifted before.
constexpr int Rounds = 4;

class EarLifter
{
public:
  EarLifter(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales,
    Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , Scales(scales)
    , ThePlacement(placement)
    , Wanted(placement.AllPoints())
  {
  }

  void Run()
  {
    std::vector<Index> ears;
    for (Index t = 0; t < this->TheMesh.TriangleCount(); ++t)
    {
      if (this->IsEar(t))
      {
        ears.push_back(t);
      }
    }
    for (int round = 0; round < Rounds; ++round)
    {
      for (Index t : ears)
      {
        if (this->ThePlacement.Quality(t) < FlatQuality)
        {
          this->Lift(t);
        }
      }
    }
  }

private:
  bool IsEar(Index t) const
  {
    const Triangle& corners = this->TheMesh.Triangles[t];
    return std::all_of(corners.begin(), corners.end(),
             [this](Index v)
             { return this->TheConnectivity.Common[v] && this->ThePlacement.IsDamaged(v); }) &&
      std::any_of(corners.begin(), corners.end(),
        [this](Index v) { return this->Wanted[v] != this->TheMesh.Points[v]; });
  }

  /// What the triangles around a vertex are worth; those with room count alike.
  double WorthAround(Index v) const
  {
    double worth = 0.0;
    for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
    {
      worth += std::min(this->ThePlacement.Quality(t), FlatQuality);
    }
    return worth;
  }

  void Lift(Index t)
  {
    const Sheet* sheet = this->ThePlacement.SheetOf(t);
    const Triangle& corners = this->TheMesh.Triangles[t];
    const auto point = [&](int corner) -> const Vec3&
    { return this->ThePlacement.PointOf(corners[corner]); };
    int longest = 0;
    for (int k = 1; k < 3; ++k)
    {
      const auto length = [&](int edge) { return (point(Next(edge)) - point(edge)).norm(); };
      longest = length(k) > length(longest) ? k : longest;
    }
    const Index middle = corners[Next(Next(longest))];
    if (sheet == nullptr || this->ThePlacement.IsPinned(middle))
    {
      return;
    }
    const Vec3 now = this->ThePlacement.PointOf(middle);
    const Vec3 along = point(Next(longest)) - point(longest);
    const Vec3 aside = sheet->Normal(now).cross(along).normalized();
    const double scale = this->Scales[middle];
    const double height = (now - point(longest)).dot(aside);
    const Vec3 lifted = now + (LeastHeight * scale - height) * aside;
    if ((lifted - this->Wanted[middle]).norm() > MostLift * scale)
    {
      return;
    }
    const double before = this->WorthAround(middle);
    this->ThePlacement.SetPoint(middle, lifted);
    if (this->WorthAround(middle) <= before)
    {
      this->ThePlacement.SetPoint(middle, now);
    }
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const std::vector<double>& Scales;
  Placement& ThePlacement;
  const std::vector<Vec3> Wanted;
};
}

void LiftEars(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales,
  Placement& placement)
{
  if (!connectivity.Common.empty())
  {
    EarLifter(mesh, connectivity, scales, placement).Run();
  }
}
}
