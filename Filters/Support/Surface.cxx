// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Surface.h"

#include "Core/EdgeLengths.h"
#include "Core/Parallel.h"
#include "Support/Parameters.h"

#include <vtkArrayDispatch.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArrayRange.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
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

/// Copies points of any type, in parallel, and looks whether they can be reckoned with.
struct PointReader
{
  std::vector<Vec3>& Points;
  double Largest; ///< coordinate
  std::atomic<vtkIdType> FirstOutOfRange;

  template <typename ArrayType>
  void operator()(ArrayType* array)
  {
    const auto from = vtk::DataArrayTupleRange<3>(array);
    ParallelFor(static_cast<Index>(from.size()),
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          Vec3& to = this->Points[v];
          for (int axis = 0; axis < 3; ++axis)
          {
            to[axis] = static_cast<double>(from[v][axis]);
          }
          // Not of NaN either.
          if (!(to.array().abs() <= this->Largest).all())
          {
            this->Report(v);
          }
        }
      });
  }

  void Report(vtkIdType v)
  {
    vtkIdType first = this->FirstOutOfRange;
    while (v < first && !this->FirstOutOfRange.compare_exchange_weak(first, v))
    {
    }
  }
};

/// Reads the points; what is wrong with them, or nothing.
std::string ReadPoints(vtkPolyData* input, std::vector<Vec3>& points)
{
  const vtkIdType count = input->GetNumberOfPoints();
  points.resize(count);
  if (count == 0)
  {
    return {};
  }
  vtkDataArray* array = input->GetPoints()->GetData();
  const bool single = array->GetDataType() == VTK_FLOAT;
  PointReader reader{ points, single ? LargestSingle : LargestLength, { count } };
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(array, reader))
  {
    reader(array);
  }
  const vtkIdType bad = reader.FirstOutOfRange;
  if (bad == count)
  {
    return {};
  }
  return "point " + std::to_string(bad) +
    (points[bad].allFinite()
        ? " is too far away: no coordinate may be larger than " + Written(reader.Largest)
        : " has a coordinate that is not a finite number");
}

/// Copies cells in parallel as long as each is a triangle of three different points that are there.
struct TriangleReader
{
  template <typename CellState>
  bool operator()(CellState& state, vtkIdType pointCount, std::vector<Triangle>& triangles) const
  {
    const auto* offsets = state.GetOffsets()->GetPointer(0);
    const auto* ids = state.GetConnectivity()->GetPointer(0);
    const vtkIdType idCount = state.GetConnectivity()->GetNumberOfValues();
    const auto count = static_cast<Index>(state.GetNumberOfCells());
    triangles.resize(count);
    std::atomic<bool> allGood(true);
    ParallelFor(count,
      [&](Index begin, Index end)
      {
        bool good = true;
        for (Index t = begin; t < end && good; ++t)
        {
          const vtkIdType first = offsets[t];
          good = offsets[t + 1] - first == 3 && first >= 0 && first + 3 <= idCount;
          for (int k = 0; k < 3 && good; ++k)
          {
            const vtkIdType id = ids[first + k];
            good = id >= 0 && id < pointCount;
            triangles[t][k] = static_cast<Index>(id);
          }
          const Triangle& triangle = triangles[t];
          good = good && triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
            triangle[2] != triangle[0];
        }
        if (!good)
        {
          allGood = false;
        }
      });
    return allGood;
  }
};

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

std::string ProblemWithSize(vtkPolyData* input)
{
  const bool fits = input->GetPolys()->GetNumberOfConnectivityIds() <= MostTriangles &&
    input->GetStrips()->GetNumberOfConnectivityIds() <= MostTriangles &&
    input->GetNumberOfPoints() <= MostTriangles;
  return fits ? std::string()
              : "the mesh is too large: at most " + std::to_string(MostTriangles) +
      " points and corners of cells can be indexed";
}

std::string ProblemWithAllCells(vtkPolyData* input)
{
  const vtkIdType pointCount = input->GetNumberOfPoints();
  const std::string problem = ProblemWithCells(input->GetPolys(), "polygon", 3, pointCount);
  return problem.empty() ? ProblemWithCells(input->GetStrips(), "triangle strip", 3, pointCount)
                         : problem;
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

/// Takes over the cells that are triangles of three different points.
void FillTriangles(vtkPolyData* output, Surface& surface)
{
  std::vector<Triangle>& triangles = surface.Triangulation.Triangles;
  const vtkIdType before = output->GetNumberOfVerts() + output->GetNumberOfLines();
  triangles.clear();
  const auto cell = vtk::TakeSmartPointer(output->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0])
    {
      triangles.push_back(
        { static_cast<Index>(ids[0]), static_cast<Index>(ids[1]), static_cast<Index>(ids[2]) });
      surface.Cells.push_back(before + cell->GetCurrentCellId());
    }
  }
}

/// Makes `output` of the input and reads its triangles; what is wrong with the cells, or nothing.
std::string ReadCells(vtkPolyData* input, vtkPolyData* output, Surface& surface)
{
  // Nearly all meshes are triangles through and through, and need no second look.
  if (input->GetNumberOfStrips() == 0 &&
    input->GetPolys()->Visit(
      TriangleReader{}, input->GetNumberOfPoints(), surface.Triangulation.Triangles))
  {
    output->ShallowCopy(input);
    surface.FirstCell = input->GetNumberOfVerts() + input->GetNumberOfLines();
    return {};
  }
  std::string problem = ProblemWithAllCells(input);
  if (problem.empty() && AllTriangles(input))
  {
    output->ShallowCopy(input);
  }
  else if (problem.empty())
  {
    problem = Triangulate(input, output);
  }
  if (problem.empty())
  {
    FillTriangles(output, surface);
  }
  return problem;
}

std::string ProblemWithScale(const Surface& surface)
{
  return surface.AverageEdgeLength > 0.0 && surface.AverageEdgeLength < SmallestLength
    ? "the mesh is too small: its edges must be longer than 1e-50 on average"
    : std::string();
}
}

std::string ReadTriangles(vtkPolyData* input, vtkPolyData* output, Surface& surface)
{
  std::string problem = ProblemWithSize(input);
  problem = problem.empty() ? ReadPoints(input, surface.Triangulation.Points) : problem;
  problem = problem.empty() ? ReadCells(input, output, surface) : problem;
  if (!problem.empty())
  {
    output->Initialize();
  }
  return problem;
}

std::string ReadSurface(vtkPolyData* input, vtkPolyData* output, Surface& surface)
{
  std::string problem = ReadTriangles(input, output, surface);
  if (problem.empty())
  {
    surface.Adjacency = Connectivity(surface.Triangulation);
    surface.AverageEdgeLength = AverageEdgeLength(surface.Triangulation, surface.Adjacency);
    problem = ProblemWithScale(surface);
  }
  if (!problem.empty())
  {
    output->Initialize();
  }
  return problem;
}

void ReplacePoints(vtkPolyData* output, const std::vector<Vec3>& after)
{
  if (after.empty())
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(output->GetPoints()->GetDataType());
  points->DeepCopy(output->GetPoints());
  std::atomic<bool> moved(false);
  ParallelFor(static_cast<Index>(after.size()),
    [&](Index begin, Index end)
    {
      bool any = false;
      for (Index v = begin; v < end; ++v)
      {
        Vec3 before;
        output->GetPoints()->GetPoint(v, before.data());
        if (after[v] != before)
        {
          points->SetPoint(v, after[v].data());
          any = true;
        }
      }
      if (any)
      {
        moved = true;
      }
    });
  if (moved)
  {
    output->SetPoints(points);
    output->GetPointData()->SetActiveNormals(nullptr);
    output->GetCellData()->SetActiveNormals(nullptr);
  }
}
}
