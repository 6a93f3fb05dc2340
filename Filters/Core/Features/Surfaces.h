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
  Index First = 0; ///< the lowest of them
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

/// Finds them, their boundary loops not yet counted.
ARRISFILTERS_EXPORT Surfaces FindSurfaces(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& sortedFeatures);

/// Makes of surfaces those that are found without some of their features.
ARRISFILTERS_EXPORT void JoinSurfaces(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& dropped, Surfaces& surfaces);

/// Counts the boundary loops. The border runs along features between two surfaces, and wherever the
/// mesh ends.
ARRISFILTERS_EXPORT void CountLoops(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<FeatureEdge>& features, Surfaces& surfaces);
}

#endif
