// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkUSSODFilter.h"

#include "Support/AssembledSurface.h"
#include "Support/Classification.h"
#include "Support/FilterMonitor.h"
#include "Support/Parameters.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkUSSODFilter);

//------------------------------------------------------------------------------
int vtkUSSODFilter::RequestMesh(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  arris::Surface surface;
  arris::ClassificationParameters parameters;
  std::string problem = arris::FirstProblem(
    { this->ProblemWithParameters() }, [&] { return this->ReadAssembly(input, output, surface); });
  problem = problem.empty() ? this->ChooseParameters(inputVector, surface, parameters) : problem;
  if (!problem.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< problem);
    return 1;
  }
  if (!this->Classifier->Update(input, surface, parameters, arris::MonitorOf(this), output))
  {
    output->Initialize(); // aborted
    return 1;
  }
  arris::ShareAmongCommon(surface, output);
  return 1;
}
