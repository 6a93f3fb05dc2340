// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Folds.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace arris
{
namespace
{
/// Under this height, as a part of the mesh's diagonal, the rounding of a single-precision point
/// (6e-8 of its coordinates) may turn a triangle by a degree.
constexpr double ThinHeight = 5e-6;

/// A thin triangle may lie at a thin one; so many of them are passed to find one that is not.
constexpr int MostThinInARow = 8;

/// A mesh of so many steep edges is noisy, or coarse and small.
constexpr double NoisyPart = 0.1;

/// In single precision, as the folds are.
using Normal = Eigen::Vector3f;
using Normals = Unfilled<Normal>;

/// Not so of the zero that stands where there is none.
bool IsKnown(const Normal& normal)
{
  return normal.squaredNorm() > 0.0F;
}

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
  for (int i = 0; i < MostThinInARow && from != NoIndex && !IsKnown(normals[from]); ++i)
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
        const auto [a, b, c] = mesh.Triangles[t];
        normals[t] =
          UnitNormal(mesh.Points[a], mesh.Points[b], mesh.Points[c], leastHeight).cast<float>();
        any = any || !IsKnown(normals[t]);
      }
      if (any)
      {
        anyThin = true;
      }
    });
  std::vector<Index> thin;
  for (Index t = 0; anyThin && t < mesh.TriangleCount(); ++t)
  {
    if (!IsKnown(normals[t]))
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
  if (!IsKnown(normal) || !IsKnown(other))
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

/// The fold of edge k of `t` and the higher triangle `other`, of which it is edge `there`.
EdgeFold ManifoldFold(
  const Mesh& mesh, const Normals& normals, Index t, int k, Index other, int there)
{
  const Triangle& triangle = mesh.Triangles[t];
  const Triangle& neighbor = mesh.Triangles[other];
  const bool alike = neighbor[there] != triangle[k];
  const float fold = DifferenceOf(normals[t], normals[other], alike);
  // Whether the other triangle falls away behind this one.
  const Vec3 across = mesh.Points[neighbor[Next(Next(there))]] - mesh.Points[triangle[k]];
  const bool convex = normals[t].cast<double>().dot(across) <= 0.0;
  return { convex ? fold : -fold, convex ? EdgeKind::Convex : EdgeKind::Concave };
}

/// Whether an edge may have more than two triangles; else it has one or two.
bool MayBeNonManifold(const Connectivity& connectivity, const Triangle& triangle, int k)
{
  return connectivity.OnBoundary[triangle[k]] && connectivity.OnBoundary[triangle[Next(k)]];
}

/// The size of the fold of edge k of `t` and one other triangle.
float ManifoldSize(const Mesh& mesh, const Normals& normals, Index t, int k, Index other)
{
  const Triangle& triangle = mesh.Triangles[t];
  const Triangle& neighbor = mesh.Triangles[other];
  const bool alike = neighbor[Next(CornerOf(neighbor, triangle[k]))] != triangle[Next(k)];
  return DifferenceOf(normals[t], normals[other], alike);
}

/// Adds edge k of `t` if it is steep, unless a lower triangle there does.
void AddIfSteep(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t,
  int k, std::vector<SteepEdge>& steep)
{
  const Index other = connectivity.AcrossEdge[t][k];
  if (other == NoIndex)
  {
    steep.push_back({ t, k, 0.0F });
    return;
  }
  if (other < t) // which it is not for the lowest one of a ring
  {
    return;
  }
  if (MayBeNonManifold(connectivity, mesh.Triangles[t], k))
  {
    std::vector<Index> ring;
    RingOfEdge(mesh, connectivity, t, k, ring);
    if (ring.size() > 2)
    {
      if (*std::min_element(ring.begin(), ring.end()) == t)
      {
        const Triangle& triangle = mesh.Triangles[t];
        steep.push_back(
          { t, k, LargestDifference(mesh, folds.Normals, ring, triangle[k], triangle[Next(k)]) });
      }
      return;
    }
  }
  const float size = ManifoldSize(mesh, folds.Normals, t, k, other);
  if (size >= folds.Least)
  {
    steep.push_back({ t, k, size });
  }
}

void KeepDifferences(const Mesh& mesh, const Connectivity& connectivity, Folds& folds)
{
  folds.Differences.resize(mesh.Triangles.size());
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          folds.Differences[t][k] = FoldAt(mesh, connectivity, folds, t, k).Difference;
        }
      }
    });
}
}

Folds FindFolds(
  const Mesh& mesh, const Connectivity& connectivity, const Monitor& monitor, double least)
{
  Folds folds;
  folds.Normals = BelievedNormals(mesh, connectivity);
  folds.Least = least;
  std::mutex adding;
  const bool finished = ParallelFor(mesh.TriangleCount(), monitor,
    [&](Index begin, Index end)
    {
      std::vector<SteepEdge> steep;
      for (Index t = begin; t < end; ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          AddIfSteep(mesh, connectivity, folds, t, k, steep);
        }
      }
      const std::lock_guard<std::mutex> lock(adding);
      folds.Steep.insert(folds.Steep.end(), steep.begin(), steep.end());
    });
  if (!finished)
  {
    return {};
  }
  if (folds.Steep.size() > NoisyPart * 1.5 * mesh.Triangles.size()) // edges a triangle
  {
    KeepDifferences(mesh, connectivity, folds);
  }
  return folds; // not by `?:`, which would copy them
}

EdgeFold FoldAt(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t, int k)
{
  const Index other = connectivity.AcrossEdge[t][k];
  if (other == NoIndex)
  {
    return { 0.0F, EdgeKind::Boundary };
  }
  const Triangle& triangle = mesh.Triangles[t];
  const Index a = triangle[k];
  const Index b = triangle[Next(k)];
  const int there = EdgeBetween(mesh.Triangles[other], a, b);
  if (connectivity.AcrossEdge[other][there] == t)
  {
    return t < other ? ManifoldFold(mesh, folds.Normals, t, k, other, there)
                     : ManifoldFold(mesh, folds.Normals, other, there, t, k);
  }
  std::vector<Index> ring;
  RingOfEdge(mesh, connectivity, t, k, ring);
  return { LargestDifference(mesh, folds.Normals, ring, a, b), EdgeKind::NonManifold };
}

float FoldSize(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t, int k)
{
  const Index other = connectivity.AcrossEdge[t][k];
  return other == NoIndex || MayBeNonManifold(connectivity, mesh.Triangles[t], k)
    ? std::abs(FoldAt(mesh, connectivity, folds, t, k).Difference)
    : ManifoldSize(mesh, folds.Normals, t, k, other);
}
}
