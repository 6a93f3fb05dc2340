// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Folds.h"

#include <algorithm>
#include <atomic>

namespace arris
{
namespace
{
/// Under this height, as a part of the mesh's diagonal, the rounding of a single-precision point
/// (6e-8 of its coordinates) may turn a triangle by a degree.
constexpr double ThinHeight = 5e-6;

/// A thin triangle may lie at a thin one; so many of them are passed to find one that is not.
constexpr int MostThinInARow = 8;

/// In single precision, as the folds are.
using Normal = Eigen::Vector3f;
using Normals = std::vector<Normal>;

/// The longest edge of a triangle; of two that are equal, as where two of its corners coincide, the
/// one to the larger neighbour: so the order of storage does not matter.
int LongestEdge(const Mesh& mesh, const Connectivity& connectivity, Index t)
{
  const Triangle& triangle = mesh.Triangles[t];
  int longest = 0;
  std::array<double, 2> most = { -1.0, 0.0 }; // squares of its length and of the neighbour's area
  for (int k = 0; k < 3; ++k)
  {
    const Index other = connectivity.AcrossEdge[t][k];
    const std::array<double, 2> edge = {
      (mesh.Points[triangle[Next(k)]] - mesh.Points[triangle[k]]).squaredNorm(),
      other == NoIndex ? 0.0 : Corners(mesh, other).AreaVector().squaredNorm()
    };
    if (edge > most)
    {
      most = edge;
      longest = k;
    }
  }
  return longest;
}

/// The normal of the first triangle that has one on the way across longest edges, oriented like the
/// thin triangle `t`; zero where there is none.
Normal NormalBeyond(
  const Mesh& mesh, const Connectivity& connectivity, const Normals& normals, Index t)
{
  Index from = t;
  float sign = 1.0F;
  for (int i = 0; i < MostThinInARow && from != NoIndex && normals[from].isZero(0.0F); ++i)
  {
    const int k = LongestEdge(mesh, connectivity, from);
    const Index to = connectivity.AcrossEdge[from][k];
    const Triangle& triangle = mesh.Triangles[from];
    if (to != NoIndex && !WoundAlike(triangle, mesh.Triangles[to], triangle[k], triangle[Next(k)]))
    {
      sign = -sign;
    }
    from = to;
  }
  return from == NoIndex ? Normal(Normal::Zero()) : Normal(sign * normals[from]);
}

/// The normals, with those of thin triangles taken over from across their longest edges; zero where
/// there is none to be had.
Normals BelievedNormals(const Mesh& mesh, const Connectivity& connectivity)
{
  const double leastHeight = ThinHeight * Diagonal(mesh);
  Normals normals(mesh.Triangles.size());
  std::atomic<bool> anyThin(false);
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      bool any = false;
      for (Index t = begin; t < end; ++t)
      {
        normals[t] = UnitNormal(Corners(mesh, t), leastHeight).cast<float>();
        any = any || normals[t].isZero(0.0F);
      }
      if (any)
      {
        anyThin = true;
      }
    });
  std::vector<Index> thin;
  for (Index t = 0; anyThin && t < mesh.TriangleCount(); ++t)
  {
    if (normals[t].isZero(0.0F))
    {
      thin.push_back(t);
    }
  }
  Normals borrowed(thin.size()); // set once all are known: a thin one lends nothing
  ParallelFor(static_cast<Index>(thin.size()),
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        borrowed[i] = NormalBeyond(mesh, connectivity, normals, thin[i]);
      }
    });
  for (std::size_t i = 0; i < thin.size(); ++i)
  {
    normals[thin[i]] = borrowed[i];
  }
  return normals;
}

/// 1 - n1.n2 of two triangles, the second one turned round unless they are wound alike; 0 if one
/// has no normal.
float DifferenceOf(const Normal& normal, const Normal& other, bool woundAlike)
{
  if (normal.isZero(0.0F) || other.isZero(0.0F))
  {
    return 0.0F;
  }
  return 0.5F * (woundAlike ? Normal(normal - other) : Normal(normal + other)).squaredNorm();
}

float LargestDifference(
  const Mesh& mesh, const Normals& normals, const std::vector<Index>& ring, Index a, Index b)
{
  float largest = 0.0F;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    for (std::size_t j = i + 1; j < ring.size(); ++j)
    {
      const bool alike = WoundAlike(mesh.Triangles[ring[i]], mesh.Triangles[ring[j]], a, b);
      largest = std::max(largest, DifferenceOf(normals[ring[i]], normals[ring[j]], alike));
    }
  }
  return largest;
}

/// Writes the fold of edge k of `t` for both triangles there: of the other one it is edge `there`.
void FindManifoldFold(
  const Mesh& mesh, const Normals& normals, Index t, int k, Index other, int there, Folds& folds)
{
  const Triangle& triangle = mesh.Triangles[t];
  const Triangle& neighbor = mesh.Triangles[other];
  const bool alike = neighbor[there] != triangle[k];
  const float fold = DifferenceOf(normals[t], normals[other], alike);
  // Whether the other triangle falls away behind this one.
  const Vec3 across = mesh.Points[neighbor[Next(Next(there))]] - mesh.Points[triangle[k]];
  const bool convex = normals[t].cast<double>().dot(across) <= 0.0;
  folds.Differences[t][k] = convex ? fold : -fold;
  folds.Differences[other][there] = folds.Differences[t][k];
  folds.Kinds[t][k] = convex ? EdgeKind::Convex : EdgeKind::Concave;
  folds.Kinds[other][there] = folds.Kinds[t][k];
}

/// Likewise for all triangles of a ring, if `t` is the lowest of them.
void FindNonManifoldFold(const Mesh& mesh, const Connectivity& connectivity, const Normals& normals,
  Index t, int k, Folds& folds)
{
  const Index a = mesh.Triangles[t][k];
  const Index b = mesh.Triangles[t][Next(k)];
  std::vector<Index> ring;
  RingOfEdge(mesh, connectivity, t, k, ring);
  if (*std::min_element(ring.begin(), ring.end()) != t)
  {
    return;
  }
  const float largest = LargestDifference(mesh, normals, ring, a, b);
  for (const Index around : ring)
  {
    const int there = EdgeBetween(mesh.Triangles[around], a, b);
    folds.Differences[around][there] = largest;
    folds.Kinds[around][there] = EdgeKind::NonManifold;
  }
}

/// Writes the fold of edge k of `t` unless a lower triangle there does.
void FindFold(const Mesh& mesh, const Connectivity& connectivity, const Normals& normals, Index t,
  int k, Folds& folds)
{
  const Index other = connectivity.AcrossEdge[t][k];
  if (other == NoIndex)
  {
    folds.Differences[t][k] = 0.0F;
    folds.Kinds[t][k] = EdgeKind::Boundary;
  }
  else if (t < other) // as it is for the lowest one of a ring, too
  {
    const Triangle& triangle = mesh.Triangles[t];
    const int there = EdgeBetween(mesh.Triangles[other], triangle[k], triangle[Next(k)]);
    if (connectivity.AcrossEdge[other][there] == t)
    {
      FindManifoldFold(mesh, normals, t, k, other, there, folds);
    }
    else
    {
      FindNonManifoldFold(mesh, connectivity, normals, t, k, folds);
    }
  }
}
}

Folds FindFolds(const Mesh& mesh, const Connectivity& connectivity, const Monitor& monitor)
{
  const Normals normals = BelievedNormals(mesh, connectivity);
  Folds folds;
  folds.Differences.resize(mesh.Triangles.size());
  folds.Kinds.resize(mesh.Triangles.size());
  const bool finished = ParallelFor(mesh.TriangleCount(), monitor,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          FindFold(mesh, connectivity, normals, t, k, folds);
        }
      }
    });
  return finished ? folds : Folds();
}
}
