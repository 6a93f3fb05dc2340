// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpEdgeExtractor.h"

#include "Core/Curves.h"
#include "Core/FeatureEdges.h"
#include "Core/Surfaces.h"
#include "Support/Arrays.h"
#include "Support/FilterMonitor.h"
#include "Support/Parameters.h"
#include "Support/Polylines.h"
#include "Support/Surface.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkSharpEdgeExtractor);

//------------------------------------------------------------------------------
vtkSharpEdgeExtractor::vtkSharpEdgeExtractor()
  : FeatureAngle(arris::DefaultFeatureAngle)
  , CornerAngle(arris::DefaultCornerAngle)
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSharpEdgeExtractor::GetCorners()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSharpEdgeExtractor::GetSurfaces()
{
  return this->GetOutput(2);
}

//------------------------------------------------------------------------------
int vtkSharpEdgeExtractor::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* curves = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* corners = vtkPolyData::GetData(outputVector, 1);
  vtkPolyData* surfaces = vtkPolyData::GetData(outputVector, 2);

  arris::Surface surface;
  const std::string problem =
    arris::FirstProblem({ arris::ProblemWithAngle("FeatureAngle", this->FeatureAngle),
                          arris::ProblemWithAngle("CornerAngle", this->CornerAngle) },
      [&] { return arris::ReadSurface(input, surfaces, surface); });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }
  if (surfaces->GetNumberOfPoints() == 0)
  {
    return 1;
  }

  const arris::Mesh& mesh = surface.Triangulation;
  const std::vector<arris::FeatureEdge> features =
    arris::FindFeatureEdges(mesh, surface.Adjacency, this->FeatureAngle, arris::MonitorOf(this));
  if (this->GetAbortExecute())
  {
    surfaces->Initialize();
    return 1;
  }
  std::vector<std::array<arris::Index, 2>> edges;
  for (const arris::FeatureEdge& feature : features)
  {
    edges.push_back({ feature.A, feature.B });
  }
  const arris::CurveNetwork network = arris::JoinEdges(edges, mesh.Points, this->CornerAngle);
  arris::FillPolylines(curves, network.Curves, surfaces);
  arris::AddCurveArrays(curves, network.Curves, features, mesh.Points);
  arris::FillCorners(corners, network.Corners, surfaces);
  arris::AddSurfaceIds(
    surfaces, arris::SurfaceIds(mesh, surface.Adjacency, features), surface.Cells);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSharpEdgeExtractor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
}
