// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpEdgeReconstruction.h"

#include "Support/Arrays.h"
#include "Support/FilterMonitor.h"
#include "Support/PaperMethod.h"
#include "Support/Parameters.h"
#include "Support/RobustMethod.h"
#include "Support/Surface.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

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
  : Method(ROBUST)
  , Window(0.0)
  , WindowRatio(0.0)
  , SharpAngle(0.0)
  , WindowSearch(CONNECTED)
  , Denoise(false)
{
}

//------------------------------------------------------------------------------
int vtkSharpEdgeReconstruction::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  arris::Surface surface;
  const std::string problem = arris::FirstProblem(
    { arris::ProblemWithOptionalWindow(this->Window, this->WindowRatio, this->WindowSearch),
      arris::ProblemWithOptionalAngle("SharpAngle", this->SharpAngle),
      ProblemWithMethod(this->Method) },
    [&] { return arris::ReadSurface(input, output, surface); });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }

  const arris::Monitor monitor = arris::MonitorOf(this);
  bool finished = false;
  if (this->Method == ROBUST)
  {
    finished = this->RecoverRobustly(surface, monitor, output);
  }
  else
  {
    arris::PaperParameters parameters;
    parameters.WindowRadius = arris::WindowRadius(this->Window,
      this->WindowRatio > 0.0 ? this->WindowRatio : arris::DefaultWindowRatio,
      surface.AverageEdgeLength);
    parameters.SharpAngle = this->SharpAngle > 0.0 ? this->SharpAngle : arris::DefaultSharpAngle;
    parameters.Search = static_cast<arris::WindowSearch>(this->WindowSearch);
    finished = arris::RecoverByPaper(surface, parameters, monitor, output);
  }
  if (!finished)
  {
    output->Initialize(); // aborted
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkSharpEdgeReconstruction::RecoverRobustly(
  const arris::Surface& surface, const arris::Monitor& monitor, vtkPolyData* output)
{
  arris::RobustParameters parameters;
  parameters.WindowRadius =
    arris::WindowRadius(this->Window, this->WindowRatio, surface.AverageEdgeLength);
  parameters.SharpAngle = this->SharpAngle;
  parameters.Denoise = this->Denoise;
  if (!arris::RecoverByRobust(surface, parameters, monitor, output))
  {
    return false;
  }
  if (arris::IsRough(output))
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
  os << indent << "Window: " << this->Window << "\n";
  os << indent << "WindowRatio: " << this->WindowRatio << "\n";
  os << indent << "SharpAngle: " << this->SharpAngle << "\n";
  os << indent << "WindowSearch: " << this->WindowSearch << "\n";
  os << indent << "Denoise: " << (this->Denoise ? "On" : "Off") << "\n";
}
