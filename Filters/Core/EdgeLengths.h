// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file EdgeLengths.h
/// How long the edges of a mesh are, to the bit the same in whatever order they are stored.

#ifndef arris_EdgeLengths_h
#define arris_EdgeLengths_h

#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The mean length of the mesh's edges, each counted once (the paper's L with a bar).
ARRISFILTERS_EXPORT double AverageEdgeLength(const Mesh& mesh, const Connectivity& connectivity);

/// Their geometric mean, on which a few huge triangles have little say. Edges without length do not
/// count; 0 if there is no other.
ARRISFILTERS_EXPORT double GeometricMeanEdgeLength(
  const Mesh& mesh, const Connectivity& connectivity);
}

#endif
