// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Polylines.h"

#include "Core/SortUnique.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace arris
{
namespace
{
/// Gives `part` these points of the mesh, with all their arrays.
void TakePoints(vtkPolyData* part, const std::vector<Index>& vertices, vtkPolyData* mesh)
{
  const vtkIdType count = static_cast<vtkIdType>(vertices.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  part->GetPointData()->CopyAllOn();
  part->GetPointData()->CopyAllocate(mesh->GetPointData(), count);
  part->GetPointData()->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, mesh->GetPoint(vertices[i]));
    part->GetPointData()->CopyData(mesh->GetPointData(), vertices[i], i);
  }
  part->SetPoints(points);
}
}

void FillPolylines(vtkPolyData* lines, const std::vector<Curve>& curves, vtkPolyData* mesh)
{
  std::vector<Index> used;
  for (const Curve& curve : curves)
  {
    used.insert(used.end(), curve.begin(), curve.end());
  }
  SortUnique(used);
  TakePoints(lines, used, mesh);

  vtkNew<vtkCellArray> cells;
  for (const Curve& curve : curves)
  {
    cells->InsertNextCell(static_cast<int>(curve.size()));
    for (Index vertex : curve)
    {
      cells->InsertCellPoint(std::lower_bound(used.begin(), used.end(), vertex) - used.begin());
    }
  }
  lines->SetLines(cells);
}
}
