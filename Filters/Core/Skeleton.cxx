// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Skeleton.h"

#include "Parallel.h"
#include "Thinning.h"

#include <algorithm>
#include <numeric>

namespace arris
{
namespace
{
Flags OnSkeleton(const std::vector<int>& rounds)
{
  const int last = rounds.empty() ? NeverSharp : *std::max_element(rounds.begin(), rounds.end());
  Flags onSkeleton(rounds.size(), 0);
  for (std::size_t v = 0; v < rounds.size(); ++v)
  {
    onSkeleton[v] = rounds[v] == last && last != NeverSharp ? 1 : 0;
  }
  return onSkeleton;
}

/// The cosine of the triangle's angle at `apex`.
double CosineAt(const Mesh& mesh, Index apex, Index a, Index b)
{
  const Vec3 toA = (mesh.Points[a] - mesh.Points[apex]).normalized();
  const Vec3 toB = (mesh.Points[b] - mesh.Points[apex]).normalized();
  return toA.dot(toB);
}

/// Whether the triangle's greatest angle is the one at `apex`.
bool IsGreatestAngle(const Mesh& mesh, Index apex, Index a, Index b)
{
  const double cosine = CosineAt(mesh, apex, a, b);
  const auto greaterThanAt = [&](Index other, Index third)
  {
    const double otherCosine = CosineAt(mesh, other, apex, third);
    return cosine < otherCosine || (cosine == otherCosine && apex < other);
  };
  return greaterThanAt(a, b) && greaterThanAt(b, a);
}

/// Whether edge (a, b) closes a triangle of skeleton vertices, opposite to its greatest angle.
bool ClosesTriangle(
  const Mesh& mesh, const Connectivity& connectivity, const Flags& onSkeleton, Index a, Index b)
{
  for (Index t : connectivity.TrianglesOfVertex[a])
  {
    const Triangle& triangle = mesh.Triangles[t];
    const int corner = CornerOf(triangle, a);
    for (int step = 1; step <= 2; ++step)
    {
      const Index other = triangle[(corner + step) % 3];
      const Index apex = triangle[(corner + 3 - step) % 3];
      if (other == b && onSkeleton[apex] && IsGreatestAngle(mesh, apex, a, b))
      {
        return true;
      }
    }
  }
  return false;
}

SkeletonRole RoleOf(bool onSkeleton, Index sharpEdges)
{
  if (!onSkeleton)
  {
    return SkeletonRole::None;
  }
  if (sharpEdges > 2)
  {
    return SkeletonRole::Joint;
  }
  return sharpEdges == 2 ? SkeletonRole::Branch : SkeletonRole::End;
}
}

std::vector<std::array<Index, 2>> Skeleton::Edges() const
{
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(this->SharpNeighbors.Values.size() / 2);
  for (Index v = 0; v < this->SharpNeighbors.size(); ++v)
  {
    for (Index neighbor : this->SharpNeighbors[v])
    {
      if (v < neighbor)
      {
        edges.push_back({ v, neighbor });
      }
    }
  }
  return edges;
}

Skeleton TraceSkeleton(
  const Mesh& mesh, const Connectivity& connectivity, const std::vector<int>& thinningRounds)
{
  const Flags onSkeleton = OnSkeleton(thinningRounds);
  Skeleton skeleton;
  skeleton.Roles.resize(mesh.Points.size());
  skeleton.SharpNeighbors.Offsets.assign(1, 0);
  skeleton.SharpNeighbors.Offsets.reserve(mesh.Points.size() + 1);
  auto& values = skeleton.SharpNeighbors.Values;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    const std::size_t before = values.size();
    if (onSkeleton[v])
    {
      for (Index neighbor : connectivity.NeighborsOfVertex[v])
      {
        if (onSkeleton[neighbor] && !ClosesTriangle(mesh, connectivity, onSkeleton, v, neighbor))
        {
          values.push_back(neighbor);
        }
      }
    }
    const Index count = static_cast<Index>(values.size() - before);
    skeleton.Roles[v] = RoleOf(onSkeleton[v] != 0, count);
    skeleton.SharpNeighbors.Offsets.push_back(static_cast<Index>(values.size()));
  }
  return skeleton;
}
}
