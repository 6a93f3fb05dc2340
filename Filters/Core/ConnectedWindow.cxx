// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConnectedWindow.h"

#include "Geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris
{
namespace
{
/// The square of the distance to a triangle that the walk comes to across its edge (a, b), or of
/// one within `enough` to some point of it, if there is one.
double SquaredDistanceAcross(
  const Mesh& mesh, Index triangle, Index a, Index b, const Vec3& center, double enough)
{
  const Triangle& corners = mesh.Triangles[triangle];
  int apex = 0;
  while (corners[apex] == a || corners[apex] == b)
  {
    ++apex;
  }
  const Vec3& from = mesh.Points[corners[Next(apex)]];
  const Vec3 along = mesh.Points[corners[Next(Next(apex))]] - from;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((center - from).dot(along) / length2, 0.0, 1.0) : 0.0;
  const Vec3 nearest = from + t * along;
  const Vec3 away = nearest - center;
  const double distance2 = away.squaredNorm();
  // Beyond the plane that passes through the edge's nearest point, facing the center, there is
  // nothing nearer; the edge is beyond it, and the apex nearly always.
  if (distance2 <= enough || (mesh.Points[corners[apex]] - nearest).dot(away) >= 0.0)
  {
    return distance2;
  }
  return SquaredDistance(center, Corners(mesh, triangle));
}
}

inline void ConnectedWindow::Visit(Index from, int edge, const Vec3& center, double radius2)
{
  const Index neighbor = this->TheConnectivity.AcrossEdge[from][edge];
  if (neighbor == NoIndex || !this->Seen.Insert(neighbor))
  {
    return;
  }
  const Triangle& corners = this->TheMesh.Triangles[from];
  const Index a = corners[edge], b = corners[Next(edge)];
  if ((this->TheMesh.Points[a] - center).squaredNorm() <= radius2 ||
    (this->TheMesh.Points[b] - center).squaredNorm() <= radius2)
  {
    this->Window.push_back(neighbor);
    return;
  }
  const double distance2 = SquaredDistanceAcross(this->TheMesh, neighbor, a, b, center, radius2);
  if (distance2 <= radius2)
  {
    this->Window.push_back(neighbor);
  }
  else if (distance2 < this->NextSquaredDistance)
  {
    this->NextSquaredDistance = distance2;
  }
}

const std::vector<Index>& ConnectedWindow::Gather(Index vertex, double radius)
{
  this->NextSquaredDistance = std::numeric_limits<double>::infinity();
  this->Window.clear();
  this->Seen.Clear();
  for (const Index t : this->TheConnectivity.TrianglesOfVertex[vertex])
  {
    this->Seen.Insert(t);
    this->Window.push_back(t);
  }
  const std::size_t own = this->Window.size();
  const Vec3& center = this->TheMesh.Points[vertex];
  // `Window` is its own queue: what stands after `i` still has to be looked around.
  for (std::size_t i = 0; i < this->Window.size(); ++i)
  {
    const Index t = this->Window[i];
    // Across the two other edges of the vertex's own triangles are triangles of the vertex.
    const int facing = i < own ? Next(CornerOf(this->TheMesh.Triangles[t], vertex)) : 0;
    const int last = i < own ? facing : 2;
    for (int k = facing; k <= last; ++k)
    {
      this->Visit(t, k, center, radius * radius);
    }
  }
  return this->Window;
}

double ConnectedWindow::NextDistance() const
{
  return std::sqrt(this->NextSquaredDistance);
}
}
