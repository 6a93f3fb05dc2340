// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PointMerging.h"

#include "Core/Assembly/CoincidentPoints.h"
#include "Core/EdgeLengths.h"
#include "Core/Flagged.h"
#include "Core/Geometry.h"

namespace arris
{
void MergeOpenPoints(double tolerance, Surface& surface)
{
  const std::vector<Index> open = Flagged(OpenVertices(surface.Triangulation, surface.Adjacency));
  if (open.empty())
  {
    return;
  }
  Mesh& mesh = surface.Triangulation;
  const std::vector<Index> merged = LowestCoincident(mesh.Points, open, tolerance * Diagonal(mesh));
  if (merged == open)
  {
    return;
  }
  std::vector<Index> becomes(mesh.Points.size());
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    becomes[v] = v;
  }
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    becomes[open[i]] = merged[i];
  }
  std::vector<vtkIdType> cells;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const Triangle& old = mesh.Triangles[t];
    const Triangle triangle{ becomes[old[0]], becomes[old[1]], becomes[old[2]] };
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
    {
      mesh.Triangles[kept] = triangle;
      cells.push_back(surface.CellOf(static_cast<Index>(t)));
      ++kept;
    }
  }
  mesh.Triangles.resize(kept);
  surface.Cells = std::move(cells);
  surface.Adjacency = Connectivity(mesh);
  surface.AverageEdgeLength = AverageEdgeLength(mesh, surface.Adjacency);
}

bool IsSoup(const Surface& surface)
{
  const auto& across = surface.Adjacency.AcrossEdge;
  return across.size() > 1 &&
    std::all_of(across.begin(), across.end(),
      [](const std::array<Index, 3>& next)
      { return next[0] == NoIndex && next[1] == NoIndex && next[2] == NoIndex; });
}
}
