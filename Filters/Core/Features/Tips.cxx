// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Tips.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
/// A tip is so many times as curved as the vertices around it are on average: on a coarsely cut
/// sphere, or in noise, they are alike.
constexpr double Concentration = 4.0;

/// Triangles of larger fans may be too thin for folds between them to be known (see Folds), and
/// these too small.
constexpr Index LargestFan = 16;

/// Adds up angles from 0 to half a turn by turning a direction by each of them: that takes one arc
/// tangent for all.
class AngleSum
{
public:
  /// The angle between two vectors; none if one of them is zero.
  void Add(const Vec3& u, const Vec3& v)
  {
    const double cosine = u.dot(v);
    const double sine = u.cross(v).norm();
    const double scale = std::abs(cosine) + sine; // keeps the direction's length from running off
    if (scale == 0.0)
    {
      return;
    }
    const bool wasBelow = this->Y < 0.0;
    const double x = (this->X * cosine - this->Y * sine) / scale;
    this->Y = (this->X * sine + this->Y * cosine) / scale;
    this->X = x;
    this->Turns += wasBelow && this->Y >= 0.0 ? 1 : 0;
  }

  /// In radians.
  double Get() const
  {
    const double rest = std::atan2(this->Y, this->X);
    return 2.0 * Pi * this->Turns + (this->Y < 0.0 ? rest + 2.0 * Pi : rest);
  }

private:
  double X = 1.0;
  double Y = 0.0;
  int Turns = 0; // whole ones
};

/// The sum of the angles of the triangles at a vertex, in radians.
double AngleAround(const Mesh& mesh, IndexSpan triangles, Index vertex)
{
  AngleSum sum;
  const Vec3& at = mesh.Points[vertex];
  for (const Index t : triangles)
  {
    const Triangle& triangle = mesh.Triangles[t];
    const int corner = CornerOf(triangle, vertex);
    sum.Add(
      mesh.Points[triangle[Next(corner)]] - at, mesh.Points[triangle[Next(Next(corner))]] - at);
  }
  return sum.Get();
}

/// What the angles around a vertex lack to a full turn, in radians: the curvature it bears. 0 on
/// the boundary.
double AngleDefect(const Mesh& mesh, const Connectivity& connectivity, Index vertex)
{
  const IndexSpan triangles = connectivity.TrianglesOfVertex[vertex];
  return connectivity.OnBoundary[vertex] || triangles.empty()
    ? 0.0
    : 2.0 * Pi - AngleAround(mesh, triangles, vertex);
}

/// What the angles around a tip lack to a full turn at least, in radians: flanks that fold by an
/// angle across the apex lean by half of it.
double LeastDefect(double tipAngle)
{
  return 2.0 * Pi * (1.0 - std::cos(0.5 * tipAngle * Pi / 180.0));
}

/// The vertices whose folds may be enough.
Flags MayBeTips(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, double least)
{
  if (folds.Least > least)
  {
    return Flags(mesh.Points.size(), 1); // no telling
  }
  Flags may(mesh.Points.size(), 0);
  for (const SteepEdge& steep : folds.Steep)
  {
    if (steep.Difference >= least)
    {
      const Triangle& triangle = mesh.Triangles[steep.Triangle];
      may[triangle[steep.Edge]] = may[triangle[Next(steep.Edge)]] = 1;
    }
  }
  const std::vector<Index>& offsets = connectivity.TrianglesOfVertex.Offsets;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    may[v] |= offsets[v + 1] - offsets[v] > LargestFan ? 1 : 0;
  }
  return may;
}

TipKind KindAt(const Mesh& mesh, const Connectivity& connectivity, Index v)
{
  const Vec3 normal = AreaVectorAround(mesh, connectivity, v);
  double height = 0.0; // above the vertices around
  for (const Index neighbor : connectivity.NeighborsOfVertex[v])
  {
    height += normal.dot(mesh.Points[v] - mesh.Points[neighbor]);
  }
  return height > 0.0 ? TipKind::Out : TipKind::In;
}
}

double LeastFoldAtTips(double tipAngle)
{
  const double defect = LeastDefect(tipAngle);
  return defect * (4.0 * Pi - defect) / (0.5 * Pi * Pi * LargestFan * LargestFan);
}

std::vector<TipKind> FindTips(const Mesh& mesh, const Connectivity& connectivity,
  const Folds& folds, const Flags& edged, double tipAngle, const Monitor& monitor)
{
  const double least = LeastDefect(tipAngle);
  const auto kind = [&](Index v)
  {
    const double defect = AngleDefect(mesh, connectivity, v);
    if (defect <= least)
    {
      return TipKind::None;
    }
    const IndexSpan neighbors = connectivity.NeighborsOfVertex[v];
    double sum = defect; // of the disc around: no noise within it changes that
    double around = 0.0;
    for (const Index neighbor : neighbors)
    {
      const double other = edged[neighbor] ? 0.0 : AngleDefect(mesh, connectivity, neighbor);
      sum += other;
      around += std::abs(other);
    }
    const bool sharp = sum > least && defect * neighbors.size() > Concentration * around;
    return sharp ? KindAt(mesh, connectivity, v) : TipKind::None;
  };
  const Flags may = MayBeTips(mesh, connectivity, folds, LeastFoldAtTips(tipAngle));
  std::vector<TipKind> tips(mesh.Points.size(), TipKind::None);
  const bool finished = ParallelFor(mesh.VertexCount(), monitor,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (may[v] && !edged[v])
        {
          tips[v] = kind(v);
        }
      }
    });
  if (!finished)
  {
    return {};
  }
  return tips;
}
}
