// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Clusters.h"

#include <algorithm>
#include <numeric>

namespace arris
{
void Clusters::Clear()
{
  for (Index v : this->Claimed)
  {
    this->SetOf[v] = NoIndex;
    this->IsMember[v] = 0;
  }
  this->Claimed.clear();
  this->Parent.clear();
}

void Clusters::Add(const std::vector<Index>& vertices)
{
  const auto set = static_cast<Index>(this->Parent.size());
  this->Parent.push_back(set);
  // Of two sets that have a vertex within an edge of both in common, one would else be two edges
  // from the other.
  for (Index v : vertices)
  {
    this->Claim(v, set);
    this->IsMember[v] = 1;
    for (Index n : this->TheConnectivity.NeighborsOfVertex[v])
    {
      this->Claim(n, set);
    }
  }
}

void Clusters::Claim(Index vertex, Index set)
{
  if (this->SetOf[vertex] == NoIndex)
  {
    this->SetOf[vertex] = set;
    this->Claimed.push_back(vertex);
    return;
  }
  const Index a = this->RootOf(this->SetOf[vertex]);
  const Index b = this->RootOf(set);
  this->Parent[std::max(a, b)] = std::min(a, b);
}

Index Clusters::RootOf(Index set)
{
  while (this->Parent[set] != set)
  {
    set = this->Parent[set] = this->Parent[this->Parent[set]];
  }
  return set;
}

Rows Clusters::Find()
{
  const std::size_t count = this->Parent.size();
  std::vector<Index> clusterOf(count);
  Rows clusters;
  clusters.Offsets.push_back(0);
  for (std::size_t set = 0; set < count; ++set)
  {
    const Index root = this->RootOf(static_cast<Index>(set));
    this->Parent[set] = root; // which is lower, and has its number
    if (root == static_cast<Index>(set))
    {
      clusterOf[set] = clusters.size();
      clusters.Offsets.push_back(0);
    }
    clusterOf[set] = clusterOf[root];
    ++clusters.Offsets[clusterOf[set] + 1];
  }
  std::partial_sum(clusters.Offsets.begin(), clusters.Offsets.end(), clusters.Offsets.begin());
  clusters.Values.resize(count);
  std::vector<Index> next(clusters.Offsets.begin(), clusters.Offsets.end() - 1);
  for (std::size_t set = 0; set < count; ++set)
  {
    clusters.Values[next[clusterOf[set]]++] = static_cast<Index>(set);
  }
  return clusters;
}
}
