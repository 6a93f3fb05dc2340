// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Faces.h
/// What the robust method asks of triangles and vertices again and again, computed once.

#ifndef arris_Robust_Faces_h
#define arris_Robust_Faces_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// A normal for every triangle and every vertex. Centroids and areas are found where they are asked
/// for, which takes no longer than to fetch them from memory.
struct Faces
{
  std::vector<Vec3> Normals; ///< unit; zero for slivers, which have no part in extremes
  std::vector<Vec3> VertexNormals; ///< unit, by area; zero where nothing is known

  ARRISFILTERS_EXPORT Faces(
    const Mesh& mesh, const Connectivity& connectivity, double averageEdgeLength);

  /// Finds those anew that vertices with the flag have a part in.
  void Update(const Mesh& mesh, const Connectivity& connectivity, const Flags& moved);

private:
  double LeastHeight; ///< of a triangle that is no sliver
};

/// The local scale h of each vertex: the mean edge length around it, smoothed over the mesh, so
/// that a coarse and a fine part can stand in one mesh.
ARRISFILTERS_EXPORT std::vector<double> LocalScales(
  const Mesh& mesh, const Connectivity& connectivity);
}

#endif
