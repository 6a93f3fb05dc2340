// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ConnectedWindow.h
/// The window of the paper's Eq. 1 found by walking the mesh outward from a vertex.

#ifndef arris_ConnectedWindow_h
#define arris_ConnectedWindow_h

#include "IndexSet.h"
#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Gathers the triangles within a distance of a vertex that can be reached from it inside that
/// distance, crossing edges. A wall that is close in space but far along the surface is not seen.
///
/// Keeps its working memory from one vertex to the next: use one object a thread. It reads the
/// points anew at each call, so they may move between calls.
class ARRISFILTERS_EXPORT ConnectedWindow
{
public:
  ConnectedWindow(const Mesh& mesh, const Connectivity& connectivity)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
  {
  }

  /// The triangles of the window, the vertex's own first. Valid until the next call.
  const std::vector<Index>& Gather(Index vertex, double radius);

  /// The distance from the last vertex to the nearest triangle that touches its window from
  /// outside; infinity if the window holds the whole connected part of the mesh.
  double NextDistance() const;

private:
  /// Takes in what is across an edge of a triangle, if it is new and near enough.
  void Visit(Index from, int edge, const Vec3& center, double radius2);

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  IndexSet Seen;
  std::vector<Index> Window;
  double NextSquaredDistance = 0.0;
};
}

#endif
