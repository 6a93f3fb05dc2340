// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpeningFilter.h"

#include "Core/Sharpening.h"
#include "Core/StopWatch.h"
#include "Support/Arrays.h"
#include "Support/AssembledSurface.h"
#include "Support/FilterMonitor.h"
#include "Support/Parameters.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <utility>

vtkStandardNewMacro(vtkSharpeningFilter);

//------------------------------------------------------------------------------
vtkSharpeningFilter::vtkSharpeningFilter()
  : Window(0.0)
  , WindowRatio(arris::DefaultWindowRatio)
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, arris::array::ThinningRound);
}

//------------------------------------------------------------------------------
int vtkSharpeningFilter::RequestMesh(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (input->GetNumberOfPoints() == 0 && input->GetNumberOfCells() == 0)
  {
    output->ShallowCopy(input);
    return 1;
  }

  std::vector<int> rounds;
  arris::Surface surface;
  const std::string problem = arris::FirstProblem(
    { arris::ProblemWithWindow(this->Window, this->WindowRatio),
      arris::ReadThinningRounds(this->GetInputArrayToProcess(0, inputVector), input, rounds) },
    [&] { return this->ReadAssembly(input, output, surface); });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }

  const arris::StopWatch watch;
  arris::Mesh& mesh = surface.Triangulation;
  const double lambda = this->Window > 0.0
    ? this->Window
    : arris::FieldValue(input, arris::array::Lambda, this->WindowRatio * surface.AverageEdgeLength);
  const arris::Skeleton skeleton = arris::TraceSkeleton(mesh, surface.Adjacency, rounds);
  std::vector<arris::Vec3> points = arris::SharpenedPoints(std::move(mesh), surface.Adjacency,
    rounds, skeleton, lambda, surface.AverageEdgeLength, arris::MonitorOf(this));
  if (points.size() != rounds.size())
  {
    output->Initialize(); // aborted
    return 1;
  }
  arris::ShareAmongCommon(surface, points);
  arris::ReplacePoints(output, points);
  arris::AddDisplacement(output, input->GetPoints());
  arris::AddFieldValue(output, arris::array::SharpeningSeconds, watch.Seconds());
  return 1;
}

//------------------------------------------------------------------------------
void vtkSharpeningFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Window: " << this->Window << "\n";
  os << indent << "WindowRatio: " << this->WindowRatio << "\n";
}
