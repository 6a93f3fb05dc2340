// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpEdgePreview.h"

#include "Core/Geometry.h"
#include "Core/StopWatch.h"
#include "Core/Thinning.h"
#include "Support/Arrays.h"
#include "Support/AssembledSurface.h"
#include "Support/Classification.h"
#include "Support/FilterMonitor.h"
#include "Support/Parameters.h"
#include "Support/PreviewMarks.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkSharpEdgePreview);

namespace
{
/// How far the progress has come when the mesh is classified, by its usual share of the time.
constexpr double Classified = 0.7;
constexpr double Thinned = 0.8;
}

//------------------------------------------------------------------------------
vtkSharpEdgePreview::vtkSharpEdgePreview()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSharpEdgePreview::GetMarks()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
int vtkSharpEdgePreview::RequestMesh(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);

  arris::Surface surface;
  arris::ClassificationParameters parameters;
  std::string problem = arris::FirstProblem(
    { this->ProblemWithParameters(), arris::ProblemWithRatio("TubeRadius", this->TubeRadius) },
    [&] { return this->ReadAssembly(input, output, surface); });
  problem = problem.empty() ? this->ChooseParameters(inputVector, surface, parameters) : problem;
  if (!problem.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< problem);
    return 1;
  }

  const arris::Mesh& mesh = surface.Triangulation;
  const arris::Monitor monitor = arris::MonitorOf(this);
  std::vector<int> rounds;
  if (this->Classifier->Update(input, surface, parameters, monitor.Part(0.0, Classified), output))
  {
    const arris::StopWatch watch;
    rounds = arris::ThinningRounds(mesh, surface.Adjacency, this->Classifier->Region(),
      this->Classifier->Differences(), monitor.Part(Classified, Thinned));
    arris::AddFieldValue(output, arris::array::ThinningSeconds, watch.Seconds());
  }
  if (rounds.size() != mesh.Points.size())
  {
    output->Initialize(); // aborted
    return 1;
  }
  const arris::Skeleton skeleton = arris::TraceSkeleton(mesh, surface.Adjacency, rounds);
  arris::AddThinning(output, rounds, skeleton.Roles);
  arris::ShareAmongCommon(surface, output);
  output->GetPointData()->SetActiveScalars(arris::array::NormalDeviation);
  arris::FillMarks(vtkPolyData::GetData(outputVector, 1), mesh,
    arris::RegionOutline(
      mesh, this->Classifier->Differences(), arris::DifferenceOfAngle(parameters.SharpAngle)),
    skeleton, this->TubeRadius * surface.AverageEdgeLength);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSharpEdgePreview::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TubeRadius: " << this->TubeRadius << "\n";
}
