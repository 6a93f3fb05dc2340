// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FreeBoundary.h
/// What keeps a vertex on the free boundary of an open mesh while it is moved.

#ifndef arris_FreeBoundary_h
#define arris_FreeBoundary_h

#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The plane that a vertex on a free boundary has to stay in: the boundary is where the surface
/// cuts it.
struct Wall
{
  Vec3 Normal = Vec3::Zero(); ///< unit; zero for a vertex that is not on a free boundary
  bool Fixed = false; ///< where the boundary itself turns sharply, and the vertex has to stay
};

/// The walls of the vertices with the flag; no entry at all if the mesh has no free boundary (edges
/// of one triangle).
///
/// Where the boundary is plane for `Reach` scales both ways, and the surface crosses that plane, it
/// is the wall: so an edge that runs into the boundary may sharpen its corner, and the boundary
/// stays in the plane that cut it. Elsewhere the wall stands on the surface along the boundary.
ARRISFILTERS_EXPORT std::vector<Wall> FindWalls(const Mesh& mesh, const Connectivity& connectivity,
  const Flags& flags, const std::vector<double>& scales);
}

#endif
