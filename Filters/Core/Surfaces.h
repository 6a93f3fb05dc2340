// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Surfaces.h
/// The smooth faces of a mesh: what its feature edges bound.

#ifndef arris_Surfaces_h
#define arris_Surfaces_h

#include "FeatureEdges.h"
#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// For each triangle the number of the smooth face it belongs to: triangles connected across edges
/// that are not features, numbered from 0 by descending area, equal ones by their lowest triangle.
ARRISFILTERS_EXPORT std::vector<Index> SurfaceIds(const Mesh& mesh,
  const Connectivity& connectivity, const std::vector<FeatureEdge>& sortedFeatures);
}

#endif
