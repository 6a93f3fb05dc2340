// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Fans.h
/// Into how many parts an assembly falls around a vertex.

#ifndef arris_Assembly_Fans_h
#define arris_Assembly_Fans_h

#include "Core/Mesh.h"

namespace arris
{
/// The triangles around each vertex in fans: those that are reached from each other by crossing
/// edges at the vertex. Keeps its working memory: use one object a thread.
class FanFinder
{
public:
  FanFinder(const Mesh& mesh, const Connectivity& connectivity)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
  {
  }

  /// For each triangle of the vertex, in their order, the number of its fan, 0 first; how many fans
  /// there are is the largest and one more. Valid until the next call.
  const std::vector<Index>& FansAround(Index vertex);

private:
  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  std::vector<Index> Fans;
  std::vector<Index> Front;
};
}

#endif
