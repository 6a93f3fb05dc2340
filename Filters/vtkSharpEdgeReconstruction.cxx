// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpEdgeReconstruction.h"

#include "Support/Arrays.h"
#include "Support/FilterMonitor.h"
#include "Support/PaperMethod.h"
#include "Support/Parameters.h"
#include "Support/Surface.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkSharpEdgeReconstruction);

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
      arris::ProblemWithAngle("SharpAngle", this->SharpAngle) },
    [&] { return arris::ReadSurface(input, output, surface); });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }

  arris::PaperParameters parameters;
  parameters.WindowRadius =
    arris::WindowRadius(this->Window, this->WindowRatio, surface.AverageEdgeLength);
  parameters.SharpAngle = this->SharpAngle;
  parameters.Search = static_cast<arris::WindowSearch>(this->WindowSearch);
  if (!arris::RecoverByPaper(surface, parameters, arris::MonitorOf(this), output))
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
