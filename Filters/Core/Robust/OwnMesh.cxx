// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnMesh.h"

#include <utility>

namespace arris
{
namespace
{
/// Undoes InOrder.
template <typename Item>
std::vector<Item> OutOfOrder(const std::vector<Index>& order, const std::vector<Item>& items)
{
  std::vector<Item> old(items.size());
  ParallelFor(static_cast<Index>(items.size()),
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        old[order[i]] = items[i];
      }
    });
  return old;
}
}

OwnMesh::OwnMesh(const Mesh& mesh, const Connectivity& connectivity)
  : TheMesh(mesh)
  , Given(mesh)
  , Frame(mesh, connectivity)
{
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        this->TheMesh.Points[v] = this->Frame.Into(mesh.Points[v]);
      }
    });
  if (this->Frame.Mirrors()) // what was outside is to stay so
  {
    for (Triangle& corners : this->TheMesh.Triangles)
    {
      std::swap(corners[1], corners[2]);
    }
  }
  this->Order = PutInOwnOrder(this->TheMesh, connectivity);
  this->TheConnectivity =
    Renumbered(connectivity, mesh.Triangles, this->Order, this->TheMesh.Triangles);
}

RobustParameters OwnMesh::Into(RobustParameters parameters) const
{
  parameters.WindowRadius /= this->Frame.Unit();
  return parameters;
}

RobustResult OwnMesh::Back(RobustResult result) const
{
  if (result.Points.empty())
  {
    return result; // stopped
  }
  for (double& radius : result.WindowRadii)
  {
    radius *= this->Frame.Unit();
  }
  const std::vector<Index>& order = this->Order.Vertices;
  result.WindowRadii = OutOfOrder(order, result.WindowRadii);
  result.NormalDifferences = OutOfOrder(order, result.NormalDifferences);
  result.Jumps = OutOfOrder(order, result.Jumps);
  result.Region = OutOfOrder(order, result.Region);
  result.Rounds = OutOfOrder(order, result.Rounds);
  result.Roles = OutOfOrder(order, result.Roles);
  result.Outcomes = OutOfOrder(order, result.Outcomes);
  result.Points = this->PointsBack(result.Points);
  result.Triangles = this->TrianglesBack(result.Triangles);
  return result;
}

std::vector<Vec3> OwnMesh::PointsBack(const std::vector<Vec3>& points) const
{
  std::vector<Vec3> back = this->Given.Points;
  ParallelFor(static_cast<Index>(points.size()),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (points[v] != this->TheMesh.Points[v])
        {
          back[this->Order.Vertices[v]] = this->Frame.Back(points[v]);
        }
      }
    });
  return back;
}

/// Triangles that were not changed keep their corners as they were given.
std::vector<Triangle> OwnMesh::TrianglesBack(const std::vector<Triangle>& triangles) const
{
  if (triangles.empty())
  {
    return {};
  }
  std::vector<Triangle> back = this->Given.Triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (triangles[t] == this->TheMesh.Triangles[t])
    {
      continue;
    }
    Triangle& corners = back[this->Order.Triangles[t]];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->Order.Vertices[triangles[t][k]];
    }
    if (this->Frame.Mirrors())
    {
      std::swap(corners[1], corners[2]);
    }
  }
  return back;
}
}
