// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Faces.h
/// What the robust method asks of triangles again and again, computed once.

#ifndef arris_Robust_Faces_h
#define arris_Robust_Faces_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Centroid, normal and area of every triangle, and a normal for every vertex.
struct Faces
{
  std::vector<Vec3> Centroids;
  std::vector<Vec3> Normals; ///< unit; zero for slivers, which have no part in extremes
  std::vector<Vec3> AreaVectors; ///< normal to the triangle, its area long
  std::vector<double> Areas;
  std::vector<Vec3> VertexNormals; ///< unit, by area; zero where nothing is known

  ARRISFILTERS_EXPORT Faces(
    const Mesh& mesh, const Connectivity& connectivity, double averageEdgeLength);
};

/// The local scale h of each vertex: the mean edge length around it, smoothed over the mesh, so
/// that a coarse and a fine part can stand in one mesh.
ARRISFILTERS_EXPORT std::vector<double> LocalScales(
  const Mesh& mesh, const Connectivity& connectivity);
}

#endif
