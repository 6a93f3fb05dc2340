// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeGraph.h"

#include "SortUnique.h"

#include <algorithm>

namespace arris
{
EdgeGraph::EdgeGraph(const std::vector<std::array<Index, 2>>& edges)
{
  this->Vertices.reserve(2 * edges.size());
  for (const auto& edge : edges)
  {
    this->Vertices.insert(this->Vertices.end(), edge.begin(), edge.end());
  }
  SortUnique(this->Vertices);

  std::vector<std::array<Index, 3>> ends; // from, to, edge
  ends.reserve(2 * edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const Index a = this->NodeOf(edges[e][0]);
    const Index b = this->NodeOf(edges[e][1]);
    ends.push_back({ a, b, static_cast<Index>(e) });
    ends.push_back({ b, a, static_cast<Index>(e) });
  }
  std::sort(ends.begin(), ends.end());
  this->Offsets.assign(this->Vertices.size() + 1, 0);
  for (const auto& end : ends)
  {
    ++this->Offsets[end[0] + 1];
    this->To.push_back(end[1]);
    this->Edges.push_back(end[2]);
  }
  for (std::size_t v = 0; v < this->Vertices.size(); ++v)
  {
    this->Offsets[v + 1] += this->Offsets[v];
  }
}

Index EdgeGraph::NodeOf(Index vertex) const
{
  const auto found = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), vertex);
  return found != this->Vertices.end() && *found == vertex
    ? static_cast<Index>(found - this->Vertices.begin())
    : NoIndex;
}
}
