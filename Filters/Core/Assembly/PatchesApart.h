// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PatchesApart.h
/// The patches of an assembly with vertices of their own.

#ifndef arris_Assembly_PatchesApart_h
#define arris_Assembly_PatchesApart_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The same triangles, but no two patches share a vertex, and neither do two parts of a patch on
/// both sides of an edge where it is cut. Whoever walks here sees one patch only.
struct PatchesApart
{
  Mesh Parts;
  Connectivity Adjacency;

  /// For each vertex of the parts the one of the whole. The first ones have the same numbers;
  /// behind them follow those that common vertices are besides.
  std::vector<Index> WholeOf;

  /// 1 for the parts of common vertices.
  Flags Common;
};

/// An assembly whose patches are worked on apart.
struct Whole
{
  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const PatchesApart& Apart;
};

/// Takes an assembly (see MakeAssembly) apart.
ARRISFILTERS_EXPORT PatchesApart TakeApart(const Mesh& whole, const Connectivity& connectivity);
}

#endif
