// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Labels.h"

#include "Core/Flagged.h"

#include <queue>

namespace arris
{
namespace
{
struct Arrival
{
  double Cost;
  Index Vertex;
  Index Label;
  bool operator<(const Arrival& other) const
  {
    return Cost != other.Cost
      ? Cost > other.Cost
      : (Vertex != other.Vertex ? Vertex > other.Vertex : Label > other.Label);
  }
};
}

std::vector<Index> FloodLabels(const Connectivity& connectivity, const Patches& patches,
  const Flags& region, const std::vector<std::vector<Side>>& sides,
  const std::vector<Index>& sidesOf)
{
  std::vector<Index> labels = patches.PatchOf;
  std::priority_queue<Arrival> arrivals;
  const auto offer = [&](Index to, Index label)
  {
    if (region[to] && labels[to] == NoIndex)
    {
      if (const Side* side = FindSide(sides[sidesOf[to]], label))
      {
        arrivals.push({ side->Cost, to, label });
      }
    }
  };
  for (Index v : Flagged(region))
  {
    for (Index n : connectivity.NeighborsOfVertex[v])
    {
      if (!region[n])
      {
        offer(v, labels[n]);
      }
    }
  }
  while (!arrivals.empty())
  {
    const Arrival next = arrivals.top();
    arrivals.pop();
    if (labels[next.Vertex] == NoIndex)
    {
      labels[next.Vertex] = next.Label;
      for (Index n : connectivity.NeighborsOfVertex[next.Vertex])
      {
        offer(n, next.Label);
      }
    }
  }
  return labels;
}
}
