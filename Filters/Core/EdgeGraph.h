// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file EdgeGraph.h
/// A few of a mesh's edges as a graph over the vertices they use.

#ifndef arris_EdgeGraph_h
#define arris_EdgeGraph_h

#include "Types.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Nodes are the vertices that the edges use, numbered anew in ascending order. Its size is that of
/// the edges, not of the mesh.
class ARRISFILTERS_EXPORT EdgeGraph
{
public:
  explicit EdgeGraph(const std::vector<std::array<Index, 2>>& edges);

  Index size() const { return static_cast<Index>(this->Vertices.size()); }
  Index MeshVertex(Index node) const { return this->Vertices[node]; }

  /// The node of a mesh vertex, or NoIndex if no edge uses it.
  Index NodeOf(Index vertex) const;

  /// The edges at a node, those to lower neighbours first.
  int Valence(Index node) const { return this->Offsets[node + 1] - this->Offsets[node]; }
  Index Neighbor(Index node, int i) const { return this->To[this->Offsets[node] + i]; }
  Index Edge(Index node, int i) const { return this->Edges[this->Offsets[node] + i]; }

  /// Where a node of valence two leads who comes from one of its neighbours.
  Index NeighborBeyond(Index from, Index node) const
  {
    return this->Neighbor(node, this->Neighbor(node, 0) == from ? 1 : 0);
  }

private:
  std::vector<Index> Vertices;
  std::vector<Index> Offsets, To, Edges;
};
}

#endif
