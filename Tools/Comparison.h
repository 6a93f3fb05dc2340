// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Comparison.h
/// How far two surfaces are apart, in the way of the program Metro.

#ifndef arris_Comparison_h
#define arris_Comparison_h

#include <vtkType.h>

#include <functional>

class vtkPolyData;

namespace arris
{
/// The distances from all of one surface to the nearest point of another, in units of length.
struct SurfaceDistance
{
  double Max = 0.0; ///< over samples in the faces, on edges and at vertices
  double Mean = 0.0; ///< over the area
  double Rms = 0.0; ///< over the area
  vtkIdType Samples = 0;
};

struct Comparison
{
  SurfaceDistance ReferenceToMesh; ///< what of the reference the mesh misses
  SurfaceDistance MeshToReference; ///< where the mesh is off the reference
  double Diagonal = 0.0; ///< of the reference's bounding box
};

/// Measures from about `samples` points in the faces of each surface, spread evenly over its area
/// (0: ten a triangle, at least 200,000), plus its vertices and as dense points on its edges.
/// Distances are to triangles, not to vertices. The result does not depend on the number of
/// threads. Polygons and strips are cut into triangles; lines, vertices and points in no cell do
/// not count. `progress` hears fractions from 0 to 1.
///
/// Throws a Failure if a surface has no area or a coordinate that is not finite.
Comparison Compare(vtkPolyData* reference, vtkPolyData* mesh, vtkIdType samples = 0,
  const std::function<void(double)>& progress = {});
}

#endif
