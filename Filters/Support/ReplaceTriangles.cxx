// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ReplaceTriangles.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <utility>

namespace arris
{
namespace
{
/// Whether the surface has a cell the other way round, so that all of its patch is wound alike.
bool IsTurnedRound(const Surface& surface, const Triangle& triangle, const vtkIdType* cell)
{
  const auto indexOf = [&](vtkIdType point)
  { return surface.SameAs.empty() ? static_cast<Index>(point) : surface.SameAs[point]; };
  return triangle[Next(CornerOf(triangle, indexOf(cell[0])))] != indexOf(cell[1]);
}
}

void ReplaceTriangles(
  vtkPolyData* output, const Surface& surface, const std::vector<Triangle>& triangles)
{
  if (triangles.empty())
  {
    return;
  }
  // Points and lines come first in the numbers of cells.
  const vtkIdType first = output->GetNumberOfVerts() + output->GetNumberOfLines();
  vtkNew<vtkCellArray> cells;
  cells->DeepCopy(output->GetPolys());
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
  {
    const Triangle& before = surface.Triangulation.Triangles[t];
    if (triangles[t] == before)
    {
      continue;
    }
    const vtkIdType cell = surface.CellOf(t) - first;
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    output->GetPolys()->GetCellAtId(cell, size, corners);
    vtkIdType after[3] = { triangles[t][0], triangles[t][1], triangles[t][2] };
    if (IsTurnedRound(surface, before, corners))
    {
      std::swap(after[1], after[2]);
    }
    cells->ReplaceCellAtId(cell, 3, after);
  }
  output->SetPolys(cells);
}
}
