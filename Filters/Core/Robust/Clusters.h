// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Clusters.h
/// Which folded triangles can be mended at the same time, as none has a part in the other's
/// mending.

#ifndef arris_Robust_Clusters_h
#define arris_Robust_Clusters_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Groups sets of vertices (each of what may move for one thing's sake) by what is near: in
/// different clusters no two are nearer than three edges. So where all is told of a vertex by those
/// within two edges of it, clusters do not see each other.
class ARRISFILTERS_EXPORT Clusters
{
public:
  explicit Clusters(const Connectivity& connectivity)
    : TheConnectivity(connectivity)
    , SetOf(connectivity.NeighborsOfVertex.size(), NoIndex)
    , IsMember(connectivity.NeighborsOfVertex.size(), 0)
  {
  }

  /// Forgets the sets before.
  void Clear();

  /// Adds a set, the next in number.
  void Add(const std::vector<Index>& vertices);

  /// The numbers of the sets of each cluster, ascending; clusters by their first.
  Rows Find();

  /// Whether a vertex may move for the sake of that set: it is in one of the cluster's; once they
  /// were found.
  bool MayMove(Index vertex, Index set) const
  {
    return this->IsMember[vertex] && this->Parent[this->SetOf[vertex]] == this->Parent[set];
  }

private:
  Index RootOf(Index set);
  void Claim(Index vertex, Index set);

  const Connectivity& TheConnectivity;
  std::vector<Index> SetOf; ///< the first that has come within an edge of each vertex
  Flags IsMember; ///< 1 for vertices in a set
  std::vector<Index> Claimed; ///< the vertices that have a set
  std::vector<Index> Parent; ///< of each set, another of its cluster; the lowest is its own
};
}

#endif
