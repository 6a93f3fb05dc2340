// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Thinning.h"

#include "SortUnique.h"

#include <algorithm>

namespace arris
{
namespace
{
/// The sharp region while it shrinks, and the test of section 4.4 on it.
class ShrinkingRegion
{
public:
  ShrinkingRegion(const Connectivity& connectivity, const Flags& sharpRegion)
    : TheConnectivity(connectivity)
    , Inside(sharpRegion)
  {
  }

  bool Contains(Index vertex) const { return this->Inside[vertex] != 0; }
  void Remove(Index vertex) { this->Inside[vertex] = 0; }

  bool TouchesOutside(Index vertex) const
  {
    const IndexSpan neighbors = this->TheConnectivity.NeighborsOfVertex[vertex];
    return std::any_of(
      neighbors.begin(), neighbors.end(), [this](Index n) { return !this->Contains(n); });
  }

  bool MayLose(Index vertex)
  {
    if (this->TheConnectivity.OnBoundary[vertex])
    {
      return false;
    }
    this->Around.clear();
    for (Index neighbor : this->TheConnectivity.NeighborsOfVertex[vertex])
    {
      if (this->Contains(neighbor))
      {
        this->Around.push_back(neighbor);
      }
    }
    return this->Around.size() > 1 && this->AroundIsConnected();
  }

private:
  /// Whether mesh edges alone connect the vertices `Around`: one row of their transitive closure.
  bool AroundIsConnected()
  {
    this->Reached.assign(this->Around.size(), 0);
    this->Reached[0] = 1;
    this->Front.assign(1, this->Around[0]);
    std::size_t count = 1;
    while (!this->Front.empty())
    {
      const Index vertex = this->Front.back();
      this->Front.pop_back();
      for (Index neighbor : this->TheConnectivity.NeighborsOfVertex[vertex])
      {
        const auto found = std::lower_bound(this->Around.begin(), this->Around.end(), neighbor);
        if (found != this->Around.end() && *found == neighbor &&
          !this->Reached[found - this->Around.begin()])
        {
          this->Reached[found - this->Around.begin()] = 1;
          this->Front.push_back(neighbor);
          ++count;
        }
      }
    }
    return count == this->Around.size();
  }

  const Connectivity& TheConnectivity;
  Flags Inside;
  std::vector<Index> Around; // ascending, as the neighbours of a vertex are
  Flags Reached;
  std::vector<Index> Front;
};

/// Puts the vertices to try in order, each once.
void SortByPriority(std::vector<Index>& vertices, const std::vector<double>& priority)
{
  SortUnique(vertices);
  if (!priority.empty())
  {
    std::stable_sort(vertices.begin(), vertices.end(),
      [&](Index a, Index b) { return priority[a] < priority[b]; });
  }
}
}

std::vector<int> ThinningRounds(const Mesh& mesh, const Connectivity& connectivity,
  const Flags& sharpRegion, const std::vector<double>& priority, const Monitor& monitor)
{
  std::vector<int> rounds(mesh.Points.size(), NeverSharp);
  ShrinkingRegion region(connectivity, sharpRegion);
  std::vector<Index> border;
  std::size_t regionSize = 0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (region.Contains(v))
    {
      ++regionSize;
      if (region.TouchesOutside(v))
      {
        border.push_back(v);
      }
    }
  }

  // Whether a vertex may go depends on its sharp neighbours alone, so a vertex that had to stay is
  // tried again only when one of those has gone.
  std::size_t removed = 0;
  int lastRound = 0; // the last that removed anything
  std::vector<Index> nextBorder;
  for (int round = 1; !border.empty(); ++round)
  {
    if (!monitor.Report(static_cast<double>(removed) / static_cast<double>(regionSize)))
    {
      return {};
    }
    SortByPriority(border, priority);
    nextBorder.clear();
    for (Index v : border)
    {
      if (!region.Contains(v) || !region.MayLose(v))
      {
        continue;
      }
      region.Remove(v);
      rounds[v] = lastRound = round;
      ++removed;
      for (Index neighbor : connectivity.NeighborsOfVertex[v])
      {
        if (region.Contains(neighbor))
        {
          nextBorder.push_back(neighbor);
        }
      }
    }
    border.swap(nextBorder);
  }

  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (region.Contains(v))
    {
      rounds[v] = lastRound + 1;
    }
  }
  return rounds;
}
}
