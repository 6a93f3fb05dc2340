// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkUSSODFilter.h"

#include "Core/Geometry.h"
#include "Core/Ussod.h"
#include "Support/Arrays.h"
#include "Support/FilterMonitor.h"
#include "Support/Parameters.h"
#include "Core/StopWatch.h"
#include "Support/Surface.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkUSSODFilter);

//------------------------------------------------------------------------------
vtkUSSODFilter::vtkUSSODFilter()
  : Window(0.0)
  , WindowRatio(arris::DefaultWindowRatio)
  , SharpAngle(arris::DefaultSharpAngle)
  , WindowSearch(CONNECTED)
{
}

//------------------------------------------------------------------------------
int vtkUSSODFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  arris::Surface surface;
  const std::string problem = arris::FirstProblem(
    { arris::ProblemWithWindow(this->Window, this->WindowRatio, this->WindowSearch),
      arris::ProblemWithAngle("SharpAngle", this->SharpAngle) },
    [&] { return arris::ReadSurface(input, output, surface); });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }

  const arris::StopWatch watch;
  const double lambda =
    arris::WindowRadius(this->Window, this->WindowRatio, surface.AverageEdgeLength);
  const std::vector<double> differences = arris::NormalDifferences(surface.Triangulation,
    surface.Adjacency, arris::UnitNormals(surface.Triangulation, surface.AverageEdgeLength), lambda,
    static_cast<arris::WindowSearch>(this->WindowSearch), arris::MonitorOf(this));
  if (differences.size() != surface.Triangulation.Points.size())
  {
    output->Initialize(); // aborted
    return 1;
  }

  this->Kappa = lambda > 0.0 ? arris::DifferenceOfAngle(this->SharpAngle) / lambda : 0.0;
  arris::AddClassification(output, differences, std::vector<double>(differences.size(), lambda),
    arris::SharpRegion(differences, this->SharpAngle));
  arris::AddFieldValue(output, arris::array::Lambda, lambda);
  arris::AddFieldValue(output, arris::array::SharpAngle, this->SharpAngle);
  arris::AddFieldValue(output, arris::array::AverageEdgeLength, surface.AverageEdgeLength);
  arris::AddFieldValue(output, arris::array::ClassificationSeconds, watch.Seconds());
  return 1;
}

//------------------------------------------------------------------------------
void vtkUSSODFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Window: " << this->Window << "\n";
  os << indent << "WindowRatio: " << this->WindowRatio << "\n";
  os << indent << "SharpAngle: " << this->SharpAngle << "\n";
  os << indent << "WindowSearch: " << this->WindowSearch << "\n";
  os << indent << "Kappa: " << this->Kappa << "\n";
}
