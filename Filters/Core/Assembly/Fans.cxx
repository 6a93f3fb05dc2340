// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Fans.h"

#include <algorithm>

namespace arris
{
const std::vector<Index>& FanFinder::FansAround(Index vertex)
{
  const IndexSpan around = this->TheConnectivity.TrianglesOfVertex[vertex];
  this->Fans.assign(static_cast<std::size_t>(around.size()), NoIndex);
  Index fan = 0;
  for (Index seed = 0; seed < around.size(); ++seed)
  {
    if (this->Fans[seed] != NoIndex)
    {
      continue;
    }
    this->Fans[seed] = fan;
    this->Front.assign(1, seed);
    while (!this->Front.empty())
    {
      const Index t = around[this->Front.back()];
      this->Front.pop_back();
      const int corner = CornerOf(this->TheMesh.Triangles[t], vertex);
      // The edges at the corner begin and end in it.
      for (const int edge : { corner, Next(Next(corner)) })
      {
        const Index beyond = this->TheConnectivity.AcrossEdge[t][edge];
        if (beyond == NoIndex)
        {
          continue;
        }
        const Index place = static_cast<Index>(
          std::lower_bound(around.begin(), around.end(), beyond) - around.begin());
        if (this->Fans[place] == NoIndex)
        {
          this->Fans[place] = fan;
          this->Front.push_back(place);
        }
      }
    }
    ++fan;
  }
  return this->Fans;
}
}
