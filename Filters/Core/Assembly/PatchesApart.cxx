// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchesApart.h"

#include "Fans.h"

#include <numeric>

namespace arris
{
PatchesApart TakeApart(const Mesh& whole, const Connectivity& connectivity)
{
  PatchesApart apart;
  apart.Parts = whole;
  apart.WholeOf.resize(whole.Points.size());
  std::iota(apart.WholeOf.begin(), apart.WholeOf.end(), 0);
  apart.Common = connectivity.Common;
  FanFinder finder(whole, connectivity);
  for (Index v = 0; v < whole.VertexCount(); ++v)
  {
    if (!connectivity.Common[v])
    {
      continue;
    }
    const Index nextPart = static_cast<Index>(apart.WholeOf.size());
    const std::vector<Index>& fans = finder.FansAround(v);
    for (std::size_t i = 0; i < fans.size(); ++i)
    {
      if (fans[i] == 0)
      {
        continue; // the first keeps the vertex
      }
      const Index part = nextPart + fans[i] - 1;
      if (part == static_cast<Index>(apart.WholeOf.size()))
      {
        apart.WholeOf.push_back(v);
        apart.Common.push_back(1);
        apart.Parts.Points.push_back(whole.Points[v]);
      }
      const Index t = connectivity.TrianglesOfVertex[v][static_cast<Index>(i)];
      apart.Parts.Triangles[t][CornerOf(whole.Triangles[t], v)] = part;
    }
  }
  apart.Adjacency = Connectivity(apart.Parts);
  apart.Adjacency.AcrossEdge = connectivity.AcrossEdge;
  return apart;
}
}
