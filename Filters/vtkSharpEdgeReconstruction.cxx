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
  , WindowRatio(arris::DefaultWindowRatio)
  , SharpAngle(arris::DefaultSharpAngle)
  , WindowSearch(CONNECTED)
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
    { arris::ProblemWithWindow(this->Window, this->WindowRatio, this->WindowSearch),
      arris::ProblemWithAngle("SharpAngle", this->SharpAngle), ProblemWithMethod(this->Method) },
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
    finished = arris::RecoverByRobust(surface, monitor, output);
  }
  else
  {
    arris::PaperParameters parameters;
    parameters.WindowRadius =
      arris::WindowRadius(this->Window, this->WindowRatio, surface.AverageEdgeLength);
    parameters.SharpAngle = this->SharpAngle;
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
void vtkSharpEdgeReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == PAPER ? "Paper" : "Robust") << "\n";
  os << indent << "Window: " << this->Window << "\n";
  os << indent << "WindowRatio: " << this->WindowRatio << "\n";
  os << indent << "SharpAngle: " << this->SharpAngle << "\n";
  os << indent << "WindowSearch: " << this->WindowSearch << "\n";
}
