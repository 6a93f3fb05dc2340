// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Surface.h"

#include "Core/Parallel.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace arris
{
namespace
{
/// The most cells for which three corners a triangle still fit an Index.
constexpr vtkIdType MostTriangles = std::numeric_limits<Index>::max() / 3;

/// The first point that is not finite, or how many points there are.
vtkIdType FirstNonFinitePoint(vtkPoints* points)
{
  std::atomic<vtkIdType> first(points->GetNumberOfPoints());
  vtkSMPTools::For(0, first,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < std::min<vtkIdType>(end, first); ++i)
      {
        double p[3];
        points->GetPoint(i, p);
        vtkIdType least = first;
        while (i < least && !(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) &&
          !first.compare_exchange_weak(least, i))
        {
        }
      }
    });
  return first;
}

/// What is wrong with the cells of one kind, or nothing.
std::string ProblemWithCells(
  vtkCellArray* cells, const char* kind, vtkIdType fewestPoints, vtkIdType pointCount)
{
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    if (count < fewestPoints)
    {
      return kind + (' ' + std::to_string(cell->GetCurrentCellId())) + " has " +
        std::to_string(count) + " points and cannot be cut into triangles";
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (ids[i] < 0 || ids[i] >= pointCount)
      {
        return kind + (' ' + std::to_string(cell->GetCurrentCellId())) + " names point " +
          std::to_string(ids[i]) + ", but there are " + std::to_string(pointCount) + " points";
      }
    }
  }
  return {};
}

std::string ProblemWith(vtkPolyData* input)
{
  const vtkIdType pointCount = input->GetNumberOfPoints();
  if (input->GetPolys()->GetNumberOfConnectivityIds() > MostTriangles ||
    input->GetStrips()->GetNumberOfConnectivityIds() > MostTriangles || pointCount > MostTriangles)
  {
    return "the mesh is too large: at most " + std::to_string(MostTriangles) +
      " points and corners of cells can be indexed";
  }
  if (pointCount > 0)
  {
    const vtkIdType bad = FirstNonFinitePoint(input->GetPoints());
    if (bad < pointCount)
    {
      return "point " + std::to_string(bad) + " has a coordinate that is not a finite number";
    }
  }
  std::string problem = ProblemWithCells(input->GetPolys(), "polygon", 3, pointCount);
  if (problem.empty())
  {
    problem = ProblemWithCells(input->GetStrips(), "triangle strip", 3, pointCount);
  }
  return problem;
}

bool AllTriangles(vtkPolyData* input)
{
  return input->GetNumberOfStrips() == 0 &&
    (input->GetNumberOfPolys() == 0 || input->GetPolys()->IsHomogeneous() == 3);
}

/// Cuts the polygons and strips of `input` into triangles in `output`; nothing, or which could not
/// be.
std::string Triangulate(vtkPolyData* input, vtkPolyData* output)
{
  // vtkTriangleFilter would also break polylines up, so it sees the surface cells alone, each with
  // its number among all cells: vertices, lines, polygons, strips.
  const vtkIdType before = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType surfaceCells = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("arris::CellNumber");
  numbers->SetNumberOfValues(surfaceCells);
  for (vtkIdType i = 0; i < surfaceCells; ++i)
  {
    numbers->SetValue(i, before + i);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(input->GetPoints());
  surface->SetPolys(input->GetPolys());
  surface->SetStrips(input->GetStrips());
  surface->GetCellData()->AddArray(numbers);
  vtkNew<vtkTriangleFilter> cutter;
  cutter->SetInputData(surface);
  cutter->Update();
  vtkPolyData* cut = cutter->GetOutput();
  const auto* from =
    vtkIdTypeArray::SafeDownCast(cut->GetCellData()->GetArray("arris::CellNumber"));

  std::vector<unsigned char> wasCut(surfaceCells, 0);
  const vtkIdType triangles = cut->GetNumberOfPolys();
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    wasCut[from->GetValue(i) - before] = 1;
  }
  for (vtkIdType i = 0; i < surfaceCells; ++i)
  {
    if (!wasCut[i])
    {
      return "cell " + std::to_string(before + i) + " cannot be cut into triangles";
    }
  }

  output->CopyStructure(input);
  output->SetPolys(cut->GetPolys());
  output->SetStrips(nullptr);
  output->GetPointData()->ShallowCopy(input->GetPointData());
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllOn();
  cellData->CopyAllocate(input->GetCellData(), before + triangles);
  cellData->SetNumberOfTuples(before + triangles);
  for (vtkIdType i = 0; i < before; ++i)
  {
    cellData->CopyData(input->GetCellData(), i, i);
  }
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    cellData->CopyData(input->GetCellData(), from->GetValue(i), before + i);
  }
  return {};
}

void FillMesh(vtkPolyData* output, Surface& surface)
{
  Mesh& mesh = surface.Triangulation;
  mesh.Points.resize(output->GetNumberOfPoints());
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        output->GetPoints()->GetPoint(v, mesh.Points[v].data());
      }
    });
  const vtkIdType before = output->GetNumberOfVerts() + output->GetNumberOfLines();
  mesh.Triangles.reserve(output->GetNumberOfPolys());
  surface.Cells.reserve(output->GetNumberOfPolys());
  const auto cell = vtk::TakeSmartPointer(output->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0])
    {
      mesh.Triangles.push_back(
        { static_cast<Index>(ids[0]), static_cast<Index>(ids[1]), static_cast<Index>(ids[2]) });
      surface.Cells.push_back(before + cell->GetCurrentCellId());
    }
  }
}
}

std::string ReadSurface(vtkPolyData* input, vtkPolyData* output, Surface& surface)
{
  std::string problem = ProblemWith(input);
  if (problem.empty())
  {
    if (AllTriangles(input))
    {
      output->ShallowCopy(input);
    }
    else
    {
      problem = Triangulate(input, output);
    }
  }
  if (!problem.empty())
  {
    output->Initialize();
    return problem;
  }
  FillMesh(output, surface);
  surface.Adjacency = Connectivity(surface.Triangulation);
  surface.AverageEdgeLength = AverageEdgeLength(surface.Triangulation, surface.Adjacency);
  return {};
}

void ReplacePoints(
  vtkPolyData* output, const std::vector<Vec3>& before, const std::vector<Vec3>& after)
{
  if (before.empty())
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(output->GetPoints()->GetDataType());
  points->DeepCopy(output->GetPoints());
  bool moved = false;
  for (std::size_t v = 0; v < after.size(); ++v)
  {
    if (after[v] != before[v])
    {
      points->SetPoint(static_cast<vtkIdType>(v), after[v].data());
      moved = true;
    }
  }
  if (moved)
  {
    output->SetPoints(points);
    output->GetPointData()->SetActiveNormals(nullptr);
    output->GetCellData()->SetActiveNormals(nullptr);
  }
}

void ReplaceTriangles(
  vtkPolyData* output, const std::vector<vtkIdType>& cells, const std::vector<Triangle>& triangles)
{
  if (triangles.empty())
  {
    return;
  }
  const vtkIdType before = output->GetNumberOfVerts() + output->GetNumberOfLines();
  vtkNew<vtkCellArray> polys;
  polys->DeepCopy(output->GetPolys());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const vtkIdType ids[3] = { triangles[t][0], triangles[t][1], triangles[t][2] };
    polys->ReplaceCellAtId(cells[t] - before, 3, ids);
  }
  output->SetPolys(polys);
}
}
