// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpThinningFilter.h"

#include "Core/StopWatch.h"
#include "Core/Thinning.h"
#include "Support/Arrays.h"
#include "Support/AssembledSurface.h"
#include "Support/FilterMonitor.h"
#include "Support/Polylines.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkSharpThinningFilter);

//------------------------------------------------------------------------------
vtkSharpThinningFilter::vtkSharpThinningFilter()
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, arris::array::SharpRegion);
  this->SetInputArrayToProcess(
    1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, arris::array::Ussod);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSharpThinningFilter::GetSkeleton()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
int vtkSharpThinningFilter::RequestMesh(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* skeletonOutput = vtkPolyData::GetData(outputVector, 1);
  if (input->GetNumberOfPoints() == 0 && input->GetNumberOfCells() == 0)
  {
    output->ShallowCopy(input);
    return 1;
  }

  std::vector<double> sharp;
  std::vector<double> priority;
  arris::Surface surface;
  std::string problem = arris::ReadPointValues(
    this->GetInputArrayToProcess(0, inputVector), arris::array::SharpRegion, input, sharp);
  if (vtkDataArray* ussod = this->GetInputArrayToProcess(1, inputVector))
  {
    problem = problem.empty() ? arris::ReadPointValues(ussod, arris::array::Ussod, input, priority)
                              : problem;
  }
  problem = problem.empty() ? this->ReadAssembly(input, output, surface) : problem;
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }

  const arris::StopWatch watch;
  const arris::Mesh& mesh = surface.Triangulation;
  const arris::Flags region = arris::NonZero(sharp);
  const std::vector<int> rounds =
    arris::ThinningRounds(mesh, surface.Adjacency, region, priority, arris::MonitorOf(this));
  if (rounds.size() != mesh.Points.size())
  {
    output->Initialize(); // aborted
    return 1;
  }
  const arris::Skeleton skeleton = arris::TraceSkeleton(mesh, surface.Adjacency, rounds);
  arris::AddThinning(output, rounds, skeleton.Roles);
  arris::ShareAmongCommon(surface, output);
  arris::AddFieldValue(output, arris::array::ThinningSeconds, watch.Seconds());

  arris::FillPolylines(
    skeletonOutput, arris::JoinEdges(skeleton.Edges(), mesh.Points).Curves, output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSharpThinningFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
