// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Roughness.h
/// How far a mesh is from being smooth away from its edges: noise, or the terraces of a
/// segmentation.

#ifndef arris_Robust_Roughness_h
#define arris_Robust_Roughness_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
struct Roughness
{
  double Height = 0.0; ///< rms distance of vertices from a smooth surface, in local edge lengths
  double Angle = 0.0; ///< rms angle between triangles and that surface, in degrees
  double Degree = 0.0; ///< 0: as smooth as exact contours are; 1: rough
  double Noise = 0.0; ///< of what is rough, 0: as even as the terraces of a segmentation; 1: noise
};

/// Measures at some thousands of vertices and takes the smoother ones of them for smooth surface,
/// as many may stand at edges.
ARRISFILTERS_EXPORT Roughness MeasureRoughness(
  const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales);
}

#endif
