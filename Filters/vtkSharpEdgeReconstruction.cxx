// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpEdgeReconstruction.h"

#include "Support/Arrays.h"
#include "Support/Classification.h"
#include "Support/FilterMonitor.h"
#include "Support/PaperMethod.h"
#include "Support/Parameters.h"
#include "Support/RobustMethod.h"
#include "Support/Surface.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <utility>

vtkStandardNewMacro(vtkSharpEdgeReconstruction);

namespace
{
std::string ProblemWithMethod(int method)
{
  const bool known =
    method == vtkSharpEdgeReconstruction::PAPER || method == vtkSharpEdgeReconstruction::ROBUST;
  return known ? std::string()
               : "Method must be 0 (paper) or 1 (robust); it is " + std::to_string(method);
}
}

//------------------------------------------------------------------------------
vtkSharpEdgeReconstruction::vtkSharpEdgeReconstruction()
{
  this->WindowRatio = 0.0;
  this->SharpAngle = 0.0;
}

//------------------------------------------------------------------------------
int vtkSharpEdgeReconstruction::RequestMesh(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  arris::Surface surface;
  arris::ClassificationParameters parameters;
  std::string problem = arris::FirstProblem(
    { arris::ProblemWithOptionalWindow(this->Window, this->WindowRatio, this->WindowSearch),
      arris::ProblemWithOptionalAngle("SharpAngle", this->SharpAngle),
      ProblemWithMethod(this->Method) },
    [&] { return this->ReadAssembly(input, output, surface); });
  problem = problem.empty() ? this->ChooseParameters(inputVector, surface, parameters) : problem;
  if (!problem.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< problem);
    return 1;
  }

  const arris::Monitor monitor = arris::MonitorOf(this);
  const bool finished = this->Method == ROBUST
    ? this->RecoverRobustly(input, surface, parameters, monitor, output)
    : arris::RecoverByPaper(
        input, std::move(surface), parameters, *this->Classifier, monitor, output);
  if (!finished)
  {
    output->Initialize(); // aborted
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkSharpEdgeReconstruction::RecoverRobustly(vtkPolyData* input, const arris::Surface& surface,
  const arris::ClassificationParameters& chosen, const arris::Monitor& monitor, vtkPolyData* output)
{
  arris::RobustParameters parameters;
  parameters.WindowRadius = this->PointsArePicked
    ? chosen.WindowRadius
    : arris::WindowRadius(this->Window, this->WindowRatio, surface.AverageEdgeLength);
  parameters.SharpAngle = this->PointsArePicked ? chosen.SharpAngle : this->SharpAngle;
  parameters.Denoise = this->Denoise;
  parameters.AllowEdgeFlips = this->AllowEdgeFlips;
  if (!arris::RecoverByRobust(input, surface, parameters, monitor, output))
  {
    return false;
  }
  this->SetUsed(arris::FieldValue(output, arris::array::Lambda, 0.0), surface.AverageEdgeLength,
    arris::FieldValue(output, arris::array::SharpAngle, 0.0));
  if (arris::AreBendsMeant(output))
  {
    vtkWarningMacro("the mesh's bends have finer triangles than its faces, as no sampling makes "
                    "them: they are taken to be meant and left as they are; set SharpAngle to "
                    "have them sharpened");
  }
  else if (arris::IsRough(output))
  {
    vtkWarningMacro(
      "the mesh is rough, as noise and segmentations are: edges were found and fitted "
      << "on a smoothed copy of it"
      << (this->Denoise ? "" : "; Denoise moves the smooth faces onto that copy as well"));
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkSharpEdgeReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == PAPER ? "Paper" : "Robust") << "\n";
  os << indent << "Denoise: " << (this->Denoise ? "On" : "Off") << "\n";
  os << indent << "AllowEdgeFlips: " << (this->AllowEdgeFlips ? "On" : "Off") << "\n";
}
