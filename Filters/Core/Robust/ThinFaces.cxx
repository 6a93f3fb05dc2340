// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ThinFaces.h"

#include "Core/Geometry.h"
#include "Core/IndexSet.h"
#include "Core/Parallel.h"

#include <cmath>

namespace arris
{
namespace
{
constexpr int LeastRing = 5; // triangles, slivers not counted
constexpr double FlatRing = 4.0; // degrees between a triangle around and the vertex normal
constexpr double LikeNormal = 20.0; // degrees within which an intact vertex is of the same face
constexpr double LikeHeight = 0.35; // and how far off its plane, in local scales
constexpr double SearchRadius = 3.0; // in local scales

bool IsFlatAround(const Connectivity& connectivity, const Faces& faces, Index vertex)
{
  const double least = std::cos(FlatRing * Pi / 180.0);
  int count = 0;
  for (Index t : connectivity.TrianglesOfVertex[vertex])
  {
    const Vec3& normal = faces.Normals[t];
    if (normal.isZero(0.0))
    {
      continue;
    }
    if (normal.dot(faces.VertexNormals[vertex]) < least)
    {
      return false;
    }
    ++count;
  }
  return count >= LeastRing;
}

/// Searches outward from a vertex for an intact one of the same face.
class Representative
{
public:
  bool Exists(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
    const Flags& region, double scale, Index vertex)
  {
    const Vec3& x = mesh.Points[vertex];
    const Vec3& normal = faces.VertexNormals[vertex];
    const double like = std::cos(LikeNormal * Pi / 180.0);
    this->Seen.Clear();
    this->Seen.Insert(vertex);
    this->Queue.assign(1, vertex);
    for (std::size_t next = 0; next < this->Queue.size(); ++next)
    {
      for (Index n : connectivity.NeighborsOfVertex[this->Queue[next]])
      {
        const Vec3 offset = mesh.Points[n] - x;
        if (offset.norm() > SearchRadius * scale || !this->Seen.Insert(n))
        {
          continue;
        }
        if (!region[n] && faces.VertexNormals[n].dot(normal) > like &&
          std::abs(offset.dot(normal)) < LikeHeight * scale)
        {
          return true;
        }
        this->Queue.push_back(n);
      }
    }
    return false;
  }

private:
  IndexSet Seen;
  std::vector<Index> Queue;
};
}

void SpareThinFaces(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& scales, Flags& region)
{
  Flags spared(region.size(), 0);
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      Representative representative;
      for (Index v = begin; v < end; ++v)
      {
        spared[v] = region[v] && IsFlatAround(connectivity, faces, v) &&
            !representative.Exists(mesh, connectivity, faces, region, scales[v], v)
          ? 1
          : 0;
      }
    });
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (spared[v])
    {
      region[v] = 0;
    }
  }
}
}
