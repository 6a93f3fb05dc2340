// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Assembly.h
/// A mesh as a collection of 2-manifold patches with common vertices (section 4.1).

#ifndef arris_Assembly_Assembly_h
#define arris_Assembly_Assembly_h

#include "Core/Mesh.h"
#include "Orientation.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// What was found on the way from the triangles as given to an assembly.
struct AssemblyFacts
{
  Index Patches = 1;
  Index CommonVertices = 0; ///< positions that several patches, or several parts of one, have
  Index JunctionEdges = 0; ///< edges of three triangles or more
  Index OpenEdges = 0; ///< edges of one triangle
  Index LeftOutTriangles = 0; ///< without area once their vertices are one, or there already
  Oriented Orientation;
};

/// What makes a mesh an assembly. SameAs and Kept are empty where its triangles stay as they are.
struct Assembly
{
  std::vector<Index> SameAs; ///< for each vertex the lowest of those at its position that it is one
                             ///< with
  std::vector<Index> Kept; ///< which of the triangles are left
  AssemblyFacts Facts;
};

/// Finds the patches of a mesh and makes it an assembly, as far as it is more than one 2-manifold.
///
/// Vertices no farther than `tolerance` apart become one (see WeldedVertices): the triangles name
/// the lowest. Triangles with different `ids` (one a triangle, or none at all) are of different
/// patches; those of one id are of one patch across edges where there are two of them; edges of
/// three and more of the same id split patches. Patches are wound one way round (see
/// OrientPatches).
///
/// Then `connectivity` shows the assembly as the paper does: walks across edges stay in a patch,
/// and start at a common vertex in all of its patches; the neighbours of a common vertex are those
/// in all its patches; ends of the edges of patches are on the boundary. Its PatchOf and Common
/// tell the rest. Where no patch has a vertex in common with another they stay empty; a closed mesh
/// without ids that is wound one way round keeps its connectivity as it is.
ARRISFILTERS_EXPORT Assembly MakeAssembly(
  Mesh& mesh, Connectivity& connectivity, std::vector<Index> ids, double tolerance);
}

#endif
