// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Features.h
/// Feature edges of test meshes, and what follows from them.

#ifndef arris_testing_Features_h
#define arris_testing_Features_h

#include "Core/Curves.h"
#include "Core/Features/FeatureSelection.h"
#include "Core/Features/Surfaces.h"
#include "Meshes.h"

namespace arris
{
namespace testing
{
/// Criteria that take every edge above an angle, and no other.
inline FeatureCriteria PlainCriteria(double angle)
{
  FeatureCriteria criteria;
  criteria.Band = { angle, angle, 180.0, 60.0 };
  criteria.NoiseFactor = 0.0;
  criteria.Boundary = false;
  criteria.NonManifold = true;
  criteria.CornerReach = 0.0;
  criteria.GapLength = 0.0;
  criteria.FoldedGapLength = 0.0;
  criteria.TailLength = 0.0;
  criteria.UnlikelyLength = 0.0;
  criteria.MinimumLength = 0.0;
  return criteria;
}

inline std::vector<FeatureEdge> Select(const Mesh& mesh, const FeatureCriteria& criteria)
{
  std::vector<FeatureEdge> edges;
  const Connectivity connectivity(mesh);
  SelectFeatures(
    mesh, connectivity, FindFolds(mesh, connectivity, Monitor()), criteria, Monitor(), edges);
  return edges;
}

inline std::vector<FeatureEdge> FeaturesAbove(const Mesh& mesh, double angle)
{
  return Select(mesh, PlainCriteria(angle));
}

/// A mesh with its features, faces and curves, the boundary among them.
struct FeatureMesh
{
  Mesh Surface;
  Connectivity Adjacency;
  std::vector<FeatureEdge> Edges;
  Surfaces Faces;
  CurveNetwork Network;

  explicit FeatureMesh(const Mesh& mesh, double angle = 30.0)
    : Surface(mesh)
    , Adjacency(mesh)
  {
    FeatureCriteria criteria = PlainCriteria(angle);
    criteria.Boundary = true;
    this->Edges = Select(mesh, criteria);
    this->Faces = FindSurfaces(mesh, this->Adjacency, this->Edges);
    CountLoops(mesh, this->Adjacency, this->Edges, this->Faces);
    this->Network = JoinEdges(EndsOf(this->Edges), mesh.Points, { 60.0 });
  }
};

/// A fold whose angle falls evenly from `angle` at y = 0 to nothing at y = `end`, and a plane from
/// there on. Its edge is on x = 0, at column `width` of 2 width + 1.
inline Mesh FadingFold(Index width, Index rows, double angle, double end)
{
  Mesh mesh = FlatGrid(2 * width, rows);
  for (Vec3& point : mesh.Points)
  {
    point.x() -= width;
    const double here = angle * std::max(0.0, 1.0 - point.y() / end);
    point.z() = -std::abs(point.x()) * std::tan(0.5 * here * Pi / 180.0);
  }
  return mesh;
}

/// The same every time, on every machine: a number from -1 to 1 (Numerical Recipes' generator).
class Dice
{
public:
  double operator()()
  {
    this->State = 1664525u * this->State + 1013904223u;
    return this->State / 2147483648.0 - 1.0;
  }

private:
  std::uint32_t State = 2006;
};

/// Moves all points by up to `size` in all directions.
inline Mesh Noisy(Mesh mesh, double size)
{
  Dice dice;
  for (Vec3& point : mesh.Points)
  {
    point += size * Vec3(dice(), dice(), dice());
  }
  return mesh;
}
}
}

#endif
