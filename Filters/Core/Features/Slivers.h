// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Slivers.h
/// Faces of a few triangles that are none: where a mesh is fine and one of its triangles is tilted.

#ifndef arris_Features_Slivers_h
#define arris_Features_Slivers_h

#include "Surfaces.h"

namespace arris
{
/// Drops the edges between slivers and the faces that they belong to; whether there were any.
///
/// A sliver has at most four triangles. It belongs to the neighbour that it folds least against (by
/// the mean angle of their common border), if that has fifty times as many triangles, on average at
/// least a quarter as large, and it folds against another neighbour by a third more at least. With
/// nothing but this neighbour around it, it belongs there as well. Slivers that lie together are
/// looked at as if the others were not there. A mesh of few large triangles, such as a CAD
/// tessellation, has no slivers.
ARRISFILTERS_EXPORT bool DropSlivers(
  const Mesh& mesh, const Surfaces& faces, std::vector<FeatureEdge>& features);
}

#endif
