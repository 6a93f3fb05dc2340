// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpatialWindow.h"

#include "Geometry.h"
#include "Parallel.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>

namespace arris
{
WindowGrid::WindowGrid(const Mesh& mesh, double radius)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.VertexCount());
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        points->SetPoint(v, mesh.Points[v].data());
      }
    });
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh.TriangleCount(), 3 * static_cast<vtkIdType>(mesh.TriangleCount()));
  for (const Triangle& triangle : mesh.Triangles)
  {
    const vtkIdType ids[3] = { triangle[0], triangle[1], triangle[2] };
    triangles->InsertNextCell(3, ids);
  }
  this->Surface->SetPoints(points);
  this->Surface->SetPolys(triangles);

  // Cubes as wide as the window, as in the paper; but no more of them than a few a triangle, so
  // that a tiny window over a large part does not fill the memory with empty cubes.
  double bounds[6];
  this->Surface->GetBounds(bounds);
  const double cubesAllowed = std::max(1000.0, 4.0 * mesh.TriangleCount());
  double width = radius;
  double wanted[3];
  for (;;)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      wanted[axis] = std::max(1.0, std::floor((bounds[2 * axis + 1] - bounds[2 * axis]) / width));
    }
    if (wanted[0] * wanted[1] * wanted[2] <= cubesAllowed)
    {
      break;
    }
    width *= 1.25;
  }
  this->Locator->SetDataSet(this->Surface);
  this->Locator->AutomaticOff();
  this->Locator->SetMaxNumberOfBuckets(static_cast<vtkIdType>(cubesAllowed));
  this->Locator->SetDivisions(
    static_cast<int>(wanted[0]), static_cast<int>(wanted[1]), static_cast<int>(wanted[2]));
  if (mesh.Triangles.empty())
  {
    return; // the locator would complain
  }
  this->Locator->BuildLocator(); // here, as it may not be built by the threads that query it
}

WindowGrid::~WindowGrid() = default;

SpatialWindow::SpatialWindow(
  const Mesh& mesh, const Connectivity& connectivity, const WindowGrid& grid)
  : TheMesh(mesh)
  , TheConnectivity(connectivity)
  , Grid(grid)
{
}

SpatialWindow::~SpatialWindow() = default;

bool SpatialWindow::SharesPatch(Index vertex, Index triangle) const
{
  const std::vector<Index>& patchOf = this->TheConnectivity.PatchOf;
  const IndexSpan around = this->TheConnectivity.TrianglesOfVertex[vertex];
  return patchOf.empty() ||
    std::any_of(
      around.begin(), around.end(), [&](Index own) { return patchOf[own] == patchOf[triangle]; });
}

const std::vector<Index>& SpatialWindow::Gather(Index vertex, double radius)
{
  this->Window.clear();
  if (this->TheMesh.Triangles.empty())
  {
    return this->Window;
  }
  const Vec3& center = this->TheMesh.Points[vertex];
  double box[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    box[2 * axis] = center[axis] - radius;
    box[2 * axis + 1] = center[axis] + radius;
  }
  // The locator answers with all the triangles of every cube that the box touches.
  const_cast<vtkStaticCellLocator*>(this->Grid.Locator.Get())
    ->FindCellsWithinBounds(box, this->Found);
  for (vtkIdType i = 0; i < this->Found->GetNumberOfIds(); ++i)
  {
    const Index t = static_cast<Index>(this->Found->GetId(i));
    if (this->SharesPatch(vertex, t) &&
      SquaredDistance(center, Corners(this->TheMesh, t)) <= radius * radius)
    {
      this->Window.push_back(t);
    }
  }
  std::sort(this->Window.begin(), this->Window.end());
  return this->Window;
}
}
