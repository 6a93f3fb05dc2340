// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Folds.h"

#include <algorithm>

namespace arris
{
namespace
{
/// Under this height, as a part of the mesh's diagonal, the rounding of a single-precision point
/// (6e-8 of its coordinates) may turn a triangle by a degree.
constexpr double ThinHeight = 5e-6;

/// A thin triangle may lie at a thin one; so many of them are passed to find one that is not.
constexpr int MostThinInARow = 8;

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
Vec3 NormalBeyond(
  const Mesh& mesh, const Connectivity& connectivity, const std::vector<Vec3>& normals, Index t)
{
  Index from = t;
  double sign = 1.0;
  for (int i = 0; i < MostThinInARow && from != NoIndex && normals[from].isZero(0.0); ++i)
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
  return from == NoIndex ? Vec3(Vec3::Zero()) : Vec3(sign * normals[from]);
}

/// The normals, with those of thin triangles taken over from across their longest edges; zero where
/// there is none to be had.
std::vector<Vec3> BelievedNormals(const Mesh& mesh, const Connectivity& connectivity)
{
  std::vector<Vec3> normals = UnitNormals(mesh, ThinHeight / SliverHeight * Diagonal(mesh));
  std::vector<Index> thin;
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    if (normals[t].isZero(0.0))
    {
      thin.push_back(t);
    }
  }
  std::vector<Vec3> borrowed(thin.size()); // set once all are known: a thin one lends nothing
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

/// 1 - n1.n2 of two triangles at the edge from `a` to `b`, oriented alike; 0 if one has no normal.
double DifferenceAcross(
  const Mesh& mesh, const std::vector<Vec3>& normals, Index t, Index other, Index a, Index b)
{
  if (normals[t].isZero(0.0) || normals[other].isZero(0.0))
  {
    return 0.0;
  }
  const bool alike = WoundAlike(mesh.Triangles[t], mesh.Triangles[other], a, b);
  const Vec3 oriented = alike ? normals[other] : Vec3(-normals[other]);
  return 0.5 * (normals[t] - oriented).squaredNorm();
}

/// Whether the other triangle falls away behind this one.
bool IsConvex(const Mesh& mesh, const Vec3& normal, Index t, Index other, int k)
{
  const Triangle& triangle = mesh.Triangles[t];
  const Triangle& neighbor = mesh.Triangles[other];
  const int edge = EdgeBetween(neighbor, triangle[k], triangle[Next(k)]);
  const Index opposite = neighbor[Next(Next(edge))];
  return normal.dot(mesh.Points[opposite] - mesh.Points[triangle[k]]) <= 0.0;
}

double LargestDifference(const Mesh& mesh, const std::vector<Vec3>& normals,
  const std::vector<Index>& ring, Index a, Index b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    for (std::size_t j = i + 1; j < ring.size(); ++j)
    {
      largest = std::max(largest, DifferenceAcross(mesh, normals, ring[i], ring[j], a, b));
    }
  }
  return largest;
}

/// Writes the fold of edge k of `t` for both triangles there; only the lower one of them does.
void FindManifoldFold(
  const Mesh& mesh, const std::vector<Vec3>& normals, Index t, int k, Index other, Folds& folds)
{
  const Index a = mesh.Triangles[t][k];
  const Index b = mesh.Triangles[t][Next(k)];
  const double fold = DifferenceAcross(mesh, normals, t, other, a, b);
  const bool convex = IsConvex(mesh, normals[t], t, other, k);
  const int there = EdgeBetween(mesh.Triangles[other], a, b);
  folds.Differences[t][k] = static_cast<float>(convex ? fold : -fold);
  folds.Differences[other][there] = folds.Differences[t][k];
  folds.Kinds[t][k] = convex ? EdgeKind::Convex : EdgeKind::Concave;
  folds.Kinds[other][there] = folds.Kinds[t][k];
}

void FindFold(const Mesh& mesh, const Connectivity& connectivity, const std::vector<Vec3>& normals,
  Index t, int k, Folds& folds)
{
  const Index other = connectivity.AcrossEdge[t][k];
  const Index a = mesh.Triangles[t][k];
  const Index b = mesh.Triangles[t][Next(k)];
  if (other == NoIndex)
  {
    folds.Differences[t][k] = 0.0F;
    folds.Kinds[t][k] = EdgeKind::Boundary;
  }
  else if (connectivity.AcrossEdge[other][EdgeBetween(mesh.Triangles[other], a, b)] != t)
  {
    std::vector<Index> ring;
    RingOfEdge(mesh, connectivity, t, k, ring);
    std::sort(ring.begin(), ring.end()); // so that all triangles of the ring agree to the last bit
    folds.Differences[t][k] = static_cast<float>(LargestDifference(mesh, normals, ring, a, b));
    folds.Kinds[t][k] = EdgeKind::NonManifold;
  }
  else if (t < other)
  {
    FindManifoldFold(mesh, normals, t, k, other, folds);
  }
}
}

void RingOfEdge(
  const Mesh& mesh, const Connectivity& connectivity, Index t, int k, std::vector<Index>& ring)
{
  const Index a = mesh.Triangles[t][k];
  const Index b = mesh.Triangles[t][Next(k)];
  ring.assign(1, t);
  for (Index next = connectivity.AcrossEdge[t][k]; next != NoIndex && next != t;
       next = connectivity.AcrossEdge[next][EdgeBetween(mesh.Triangles[next], a, b)])
  {
    ring.push_back(next);
  }
}

Folds FindFolds(const Mesh& mesh, const Connectivity& connectivity, const Monitor& monitor)
{
  const std::vector<Vec3> normals = BelievedNormals(mesh, connectivity);
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
