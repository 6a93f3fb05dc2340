// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Faces.h"

#include "Core/Geometry.h"
#include "Core/Parallel.h"

#include <algorithm>

namespace arris
{
namespace
{
/// Triangles lower than this part of the average edge are slivers: exact ones exist in contours,
/// but their normal is the first to suffer from anything that is not.
constexpr double RobustSliverHeight = 0.05;

/// How often the scale is averaged with that of the neighbours: evens out over about five edges.
constexpr int ScaleSmoothing = 30;
}

Faces::Faces(const Mesh& mesh, const Connectivity& connectivity, double averageEdgeLength)
  : Normals(mesh.Triangles.size())
  , VertexNormals(mesh.Points.size())
  , LeastHeight(RobustSliverHeight * averageEdgeLength)
{
  this->Update(mesh, connectivity, Flags(mesh.Points.size(), 1));
}

void Faces::Update(const Mesh& mesh, const Connectivity& connectivity, const Flags& moved)
{
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const Triangle& corners = mesh.Triangles[t];
        if (moved[corners[0]] || moved[corners[1]] || moved[corners[2]])
        {
          this->Normals[t] = UnitNormal(Corners(mesh, t), this->LeastHeight);
        }
      }
    });
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const IndexSpan neighbors = connectivity.NeighborsOfVertex[v];
        if (moved[v] ||
          std::any_of(neighbors.begin(), neighbors.end(), [&](Index n) { return moved[n] != 0; }))
        {
          this->VertexNormals[v] = DirectionOf(AreaVectorAround(mesh, connectivity, v));
        }
      }
    });
}

std::vector<double> LocalScales(const Mesh& mesh, const Connectivity& connectivity)
{
  // Sum and number of edges are smoothed apart, so that a vertex of many edges counts for more.
  using SumAndCount = std::array<double, 2>;
  std::vector<SumAndCount> now(mesh.Points.size());
  std::vector<SumAndCount> next(mesh.Points.size());
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        double sum = 0.0;
        for (Index n : connectivity.NeighborsOfVertex[v])
        {
          sum += (mesh.Points[n] - mesh.Points[v]).norm();
        }
        now[v] = { sum, static_cast<double>(connectivity.NeighborsOfVertex[v].size()) };
      }
    });
  for (int pass = 0; pass < ScaleSmoothing; ++pass)
  {
    ParallelFor(mesh.VertexCount(),
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          SumAndCount total = now[v];
          for (Index n : connectivity.NeighborsOfVertex[v])
          {
            total[0] += now[n][0];
            total[1] += now[n][1];
          }
          const double share = 1.0 / (1.0 + connectivity.NeighborsOfVertex[v].size());
          next[v] = { total[0] * share, total[1] * share };
        }
      });
    now.swap(next);
  }
  std::vector<double> scales(mesh.Points.size());
  for (std::size_t v = 0; v < scales.size(); ++v)
  {
    scales[v] = now[v][1] > 0.0 ? now[v][0] / now[v][1] : 0.0;
  }
  return scales;
}
}
