// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Mesh.h
/// A triangle mesh in flat arrays, and the adjacency every stage of the method walks on.

#ifndef arris_Mesh_h
#define arris_Mesh_h

#include "Types.h"
#include "Unfilled.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Points (any length unit) and the triangles on them. No triangle names a vertex twice, and every
/// index is in range: whoever fills a Mesh sees to it.
struct Mesh
{
  std::vector<Vec3> Points;
  std::vector<Triangle> Triangles;

  Index VertexCount() const { return static_cast<Index>(this->Points.size()); }
  Index TriangleCount() const { return static_cast<Index>(this->Triangles.size()); }
};

/// A mesh, or its triangles on points that have moved.
struct MeshView
{
  const std::vector<Vec3>& Points;
  const std::vector<Triangle>& Triangles;

  MeshView(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
    : Points(points)
    , Triangles(triangles)
  {
  }
  MeshView(const Mesh& mesh) // is one as it is
    : MeshView(mesh.Points, mesh.Triangles)
  {
  }
  Index TriangleCount() const { return static_cast<Index>(this->Triangles.size()); }
};

/// Rows of indices of different lengths, stored end to end (compressed sparse rows).
class Rows
{
public:
  std::vector<Index> Offsets; ///< one more than there are rows
  Unfilled<Index> Values;

  Index size() const { return static_cast<Index>(this->Offsets.size()) - 1; }
  IndexSpan operator[](Index row) const
  {
    return { this->Values.data() + this->Offsets[row],
      this->Values.data() + this->Offsets[row + 1] };
  }
};

/// Who touches whom. Depends on the triangles alone, not on the points.
struct ARRISFILTERS_EXPORT Connectivity
{
  /// The triangles around each vertex, ascending.
  Rows TrianglesOfVertex;

  /// The vertices one edge away from each vertex, ascending.
  Rows NeighborsOfVertex;

  /// For edge k of each triangle (from its corner k to corner k + 1) the next triangle around that
  /// edge: the one on the other side, or NoIndex on the boundary of the mesh. Around a non-manifold
  /// edge the triangles follow each other in a ring, so that a walk still reaches all of them.
  Unfilled<std::array<Index, 3>> AcrossEdge;

  /// 1 for the ends of edges that do not have exactly two triangles: the boundary of the mesh and
  /// of the 2-manifold patches of a non-manifold one.
  Flags OnBoundary;

  /// In an assembly of patches (see Assembly.h), for each triangle its patch, and 1 for the
  /// vertices that several patches have in common; else both are empty.
  std::vector<Index> PatchOf;
  Flags Common;

  Connectivity() = default;
  explicit Connectivity(const Mesh& mesh);
};

/// Whether any edge has other than two triangles.
bool HasBoundary(const Connectivity& connectivity);

/// The triangles that have any of these vertices, ascending.
std::vector<Index> TrianglesAround(
  const Connectivity& connectivity, const std::vector<Index>& vertices);

/// Whether two triangles are of one patch, as all are that are in no assembly.
inline bool AreOnePatch(const Connectivity& connectivity, Index a, Index b)
{
  return connectivity.PatchOf.empty() || connectivity.PatchOf[a] == connectivity.PatchOf[b];
}

/// 1 for the ends of edges with one triangle.
Flags OpenVertices(const Mesh& mesh, const Connectivity& connectivity);

/// The corner after this one, going round a triangle; edge k runs from corner k to Next(k).
constexpr int Next(int corner)
{
  return corner == 2 ? 0 : corner + 1;
}

/// Where in a triangle a vertex is, 0 to 2.
inline int CornerOf(const Triangle& triangle, Index vertex)
{
  return triangle[0] == vertex ? 0 : (triangle[1] == vertex ? 1 : 2);
}

/// The corner where the triangle's edge between two vertices starts, whichever way it runs.
inline int EdgeBetween(const Triangle& triangle, Index a, Index b)
{
  const int corner = CornerOf(triangle, a);
  return triangle[Next(corner)] == b ? corner : CornerOf(triangle, b);
}

/// The triangles around edge k of `t`, from `t` on.
ARRISFILTERS_EXPORT void RingOfEdge(
  const Mesh& mesh, const Connectivity& connectivity, Index t, int k, std::vector<Index>& ring);
}

#endif
