// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAssemblyAlgorithm.h"

#include "Support/AssembledSurface.h"
#include "Support/Blocks.h"
#include "Support/Parameters.h"
#include "Support/PatchIds.h"

#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

//------------------------------------------------------------------------------
vtkAssemblyAlgorithm::vtkAssemblyAlgorithm()
  : PatchArrayName(arris::DefaultPatchArray)
  , MergeTolerance(arris::DefaultMergeTolerance)
  , TheBlocks(std::make_unique<arris::Blocks>())
{
}

vtkAssemblyAlgorithm::~vtkAssemblyAlgorithm() = default;

//------------------------------------------------------------------------------
int vtkAssemblyAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  return 1;
}

int vtkAssemblyAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // that of the input
    return 1;
  }
  return this->Superclass::FillOutputPortInformation(port, info);
}

//------------------------------------------------------------------------------
vtkTypeBool vtkAssemblyAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT())
    ? this->RequestDataObject(inputVector, outputVector)
    : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkAssemblyAlgorithm::RequestDataObject(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (input == nullptr)
  {
    return 0;
  }
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  if (output == nullptr || output->GetDataObjectType() != input->GetDataObjectType())
  {
    const auto made = vtk::TakeSmartPointer(input->NewInstance());
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  for (int port = 1; port < this->GetNumberOfOutputPorts(); ++port)
  {
    if (vtkPolyData::GetData(outputVector, port) == nullptr)
    {
      outputVector->GetInformationObject(port)->Set(
        vtkDataObject::DATA_OBJECT(), vtkNew<vtkPolyData>());
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkAssemblyAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkCompositeDataSet::GetData(inputVector[0]) != nullptr
    ? this->RequestBlocks(inputVector, outputVector)
    : this->RequestMesh(inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkAssemblyAlgorithm::RequestBlocks(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkCompositeDataSet* input = vtkCompositeDataSet::GetData(inputVector[0]);
  vtkCompositeDataSet* output = vtkCompositeDataSet::GetData(outputVector, 0);
  const std::string problem = this->TheBlocks->Join(input);
  if (!problem.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< problem);
    return 1;
  }

  // The same request with the blocks as one mesh on the first port.
  vtkNew<vtkInformationVector> wholeInput;
  wholeInput->Copy(inputVector[0], 1);
  wholeInput->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), this->TheBlocks->Whole());
  std::vector<vtkInformationVector*> inputs(
    inputVector, inputVector + this->GetNumberOfInputPorts());
  inputs[0] = wholeInput;
  vtkNew<vtkPolyData> whole;
  vtkNew<vtkInformationVector> wholeOutput;
  wholeOutput->Copy(outputVector, 1);
  wholeOutput->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), whole);
  const int result = this->RequestMesh(inputs.data(), wholeOutput);
  if (whole->GetNumberOfPoints() == this->TheBlocks->Whole()->GetNumberOfPoints())
  {
    this->TheBlocks->Part(input, whole, output);
  }
  else
  {
    output->Initialize(); // an error, or aborted
  }
  return result;
}

//------------------------------------------------------------------------------
arris::AssemblyParameters vtkAssemblyAlgorithm::AssemblyParametersFor(vtkPolyData* input) const
{
  // Blocks are patches where no array tells more.
  vtkCellData* cellData = input->GetCellData();
  const bool byBlock = cellData->HasArray(arris::BlockArray) != 0 &&
    this->PatchArrayName == arris::DefaultPatchArray &&
    cellData->HasArray(arris::DefaultPatchArray) == 0 &&
    cellData->HasArray(arris::BoundaryLabelsArray) == 0;
  return { byBlock ? arris::BlockArray : this->PatchArrayName, this->MergeTolerance };
}

std::string vtkAssemblyAlgorithm::ReadAssembly(
  vtkPolyData* input, vtkPolyData* output, arris::Surface& surface)
{
  std::string problem =
    arris::FirstProblem({ arris::ProblemWithSize("MergeTolerance", this->MergeTolerance) },
      [&]
      {
        const std::string unread = arris::ReadSurface(input, output, surface);
        return unread.empty()
          ? arris::AssembleSurface(output, this->AssemblyParametersFor(input), surface)
          : unread;
      });
  if (!problem.empty())
  {
    output->Initialize();
    surface = arris::Surface();
  }
  this->NumberOfPatches = surface.Triangulation.Triangles.empty() ? 0 : surface.Facts.Patches;
  this->NumberOfCommonVertices = surface.Facts.CommonVertices;
  this->NumberOfJunctionEdges = surface.Facts.JunctionEdges;
  this->NumberOfOpenEdges = surface.Facts.OpenEdges;
  this->NumberOfOneSidedPatches = surface.Facts.Orientation.OneSidedPatches;
  return problem;
}

//------------------------------------------------------------------------------
void vtkAssemblyAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PatchArrayName: " << this->PatchArrayName << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "NumberOfCommonVertices: " << this->NumberOfCommonVertices << "\n";
  os << indent << "NumberOfJunctionEdges: " << this->NumberOfJunctionEdges << "\n";
  os << indent << "NumberOfOpenEdges: " << this->NumberOfOpenEdges << "\n";
  os << indent << "NumberOfOneSidedPatches: " << this->NumberOfOneSidedPatches << "\n";
}
