// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AssembledSurface.h"

#include "Core/EdgeLengths.h"
#include "Core/Geometry.h"
#include "Support/Arrays.h"
#include "Support/PatchIds.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <utility>

namespace arris
{
std::string AssembleSurface(
  vtkPolyData* output, const AssemblyParameters& parameters, Surface& surface)
{
  std::vector<Index> ids;
  std::string problem = ReadPatchIds(output, parameters.PatchArray, surface, ids);
  if (!problem.empty())
  {
    return problem;
  }
  Mesh& mesh = surface.Triangulation;
  Assembly assembly = MakeAssembly(
    mesh, surface.Adjacency, std::move(ids), parameters.MergeTolerance * Diagonal(mesh));
  if (!assembly.SameAs.empty())
  {
    surface.AverageEdgeLength = AverageEdgeLength(mesh, surface.Adjacency);
  }
  if (assembly.Facts.LeftOutTriangles > 0)
  {
    std::vector<vtkIdType> cells;
    for (const Index t : assembly.Kept)
    {
      cells.push_back(surface.CellOf(t));
    }
    surface.Cells = std::move(cells);
  }
  surface.AssembledBy = parameters;
  surface.SameAs = std::move(assembly.SameAs);
  surface.Facts = assembly.Facts;
  return {};
}

void ShareAmongCommon(const Surface& surface, std::vector<Vec3>& points)
{
  for (std::size_t v = 0; v < surface.SameAs.size(); ++v)
  {
    points[v] = points[surface.SameAs[v]];
  }
}

void ShareAmongCommon(const Surface& surface, vtkPolyData* output)
{
  for (const char* name :
    { array::Ussod, array::NormalDeviation, array::SharpRegion, array::ThinningRound,
      array::SkeletonRole, array::Window, array::EdgeAngle, array::Outcome })
  {
    vtkDataArray* values = output->GetPointData()->GetArray(name);
    for (std::size_t v = 0; values != nullptr && v < surface.SameAs.size(); ++v)
    {
      const auto own = static_cast<vtkIdType>(v);
      if (surface.SameAs[v] != own)
      {
        values->SetTuple(own, surface.SameAs[v], values);
      }
    }
  }
}
}
