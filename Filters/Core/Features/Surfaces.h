// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Surfaces.h
/// The smooth faces of a mesh: what its feature edges bound.

#ifndef arris_Features_Surfaces_h
#define arris_Features_Surfaces_h

#include "FeatureEdges.h"

namespace arris
{
/// What can be counted and measured of a smooth face.
struct SurfaceMeasures
{
  double Area = 0.0;
  Index Triangles = 0;
  Index BoundaryLoops = 0; ///< connected pieces of its border with other faces and with nothing
};

struct Surfaces
{
  /// For each triangle the number of the smooth face it belongs to: triangles connected across
  /// edges that are not features, numbered from 0 by descending area, equal ones by their lowest
  /// triangle.
  std::vector<Index> Ids;

  std::vector<SurfaceMeasures> Measures; ///< by number
};

ARRISFILTERS_EXPORT Surfaces FindSurfaces(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& sortedFeatures);
}

#endif
