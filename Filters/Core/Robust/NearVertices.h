// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file NearVertices.h
/// The vertices near a point that a walk over the mesh reaches without leaving a ball.

#ifndef arris_Robust_NearVertices_h
#define arris_Robust_NearVertices_h

#include "Core/IndexSet.h"
#include "Core/Mesh.h"

namespace arris
{
/// Keeps its working memory: use one object a thread.
class NearVertices
{
public:
  /// The vertices within `radius` of `center`, `start` first and whatever its distance, then in the
  /// order in which a walk reaches them. Valid until the next call.
  const std::vector<Index>& Gather(const std::vector<Vec3>& points,
    const Connectivity& connectivity, Index start, const Vec3& center, double radius)
  {
    this->Seen.Clear();
    this->Seen.Insert(start);
    this->Found.assign(1, start);
    for (std::size_t next = 0; next < this->Found.size(); ++next)
    {
      for (Index n : connectivity.NeighborsOfVertex[this->Found[next]])
      {
        // Asked first, as each vertex is met once from each of its neighbours.
        if (this->Seen.Insert(n) && (points[n] - center).squaredNorm() <= radius * radius)
        {
          this->Found.push_back(n);
        }
      }
    }
    return this->Found;
  }

private:
  IndexSet Seen;
  std::vector<Index> Found;
};
}

#endif
