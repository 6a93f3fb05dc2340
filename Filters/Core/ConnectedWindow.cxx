// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConnectedWindow.h"

#include "Geometry.h"

#include <cmath>
#include <limits>

namespace arris
{
const std::vector<Index>& ConnectedWindow::Gather(Index vertex, double radius)
{
  const Vec3& center = this->TheMesh.Points[vertex];
  const double radius2 = radius * radius;
  this->NextSquaredDistance = std::numeric_limits<double>::infinity();
  this->Window.clear();
  this->Seen.Clear();
  for (Index t : this->TheConnectivity.TrianglesOfVertex[vertex])
  {
    this->Seen.Insert(t);
    this->Window.push_back(t);
  }
  // `Window` is its own queue: what stands after `next` still has to be looked around.
  for (std::size_t next = 0; next < this->Window.size(); ++next)
  {
    for (Index neighbor : this->TheConnectivity.AcrossEdge[this->Window[next]])
    {
      if (neighbor == NoIndex || !this->Seen.Insert(neighbor))
      {
        continue;
      }
      const double distance2 = SquaredDistance(center, Corners(this->TheMesh, neighbor));
      if (distance2 <= radius2)
      {
        this->Window.push_back(neighbor);
      }
      else if (distance2 < this->NextSquaredDistance)
      {
        this->NextSquaredDistance = distance2;
      }
    }
  }
  return this->Window;
}

double ConnectedWindow::NextDistance() const
{
  return std::sqrt(this->NextSquaredDistance);
}
}
