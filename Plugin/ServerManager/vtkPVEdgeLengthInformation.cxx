// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPVEdgeLengthInformation.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkClientServerStream.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkMath.h>
#include <vtkMultiProcessStream.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>

vtkStandardNewMacro(vtkPVEdgeLengthInformation);

namespace
{
void AddEdges(vtkPolyData* mesh, double& length, double& count)
{
  if (mesh == nullptr || mesh->GetPolys() == nullptr)
  {
    return;
  }
  const auto polygon = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polygon->GoToFirstCell(); !polygon->IsDoneWithTraversal(); polygon->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    polygon->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double a[3];
      double b[3];
      mesh->GetPoint(ids[i], a);
      mesh->GetPoint(ids[(i + 1) % size], b);
      length += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
      count += 1.0;
    }
  }
}
}

//------------------------------------------------------------------------------
double vtkPVEdgeLengthInformation::GetAverageEdgeLength() const
{
  const double mean = this->Count > 0.0 ? this->Length / this->Count : 0.0;
  return std::isfinite(mean) ? mean : 0.0;
}

//------------------------------------------------------------------------------
void vtkPVEdgeLengthInformation::CopyFromObject(vtkObject* object)
{
  this->Length = 0.0;
  this->Count = 0.0;
  vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(object);
  if (algorithm == nullptr || this->PortNumber >= algorithm->GetNumberOfOutputPorts())
  {
    return;
  }
  vtkDataObject* data = algorithm->GetOutputDataObject(this->PortNumber);
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto block = vtk::TakeSmartPointer(blocks->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      AddEdges(vtkPolyData::SafeDownCast(block->GetCurrentDataObject()), this->Length, this->Count);
    }
    return;
  }
  AddEdges(vtkPolyData::SafeDownCast(data), this->Length, this->Count);
}

//------------------------------------------------------------------------------
void vtkPVEdgeLengthInformation::AddInformation(vtkPVInformation* other)
{
  if (auto* more = vtkPVEdgeLengthInformation::SafeDownCast(other))
  {
    this->Length += more->Length;
    this->Count += more->Count;
  }
}

//------------------------------------------------------------------------------
void vtkPVEdgeLengthInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << this->Length << this->Count
          << vtkClientServerStream::End;
}

void vtkPVEdgeLengthInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  if (!stream->GetArgument(0, 0, &this->Length) || !stream->GetArgument(0, 1, &this->Count))
  {
    vtkErrorMacro(<< "the server's reply holds no edge lengths");
  }
}

//------------------------------------------------------------------------------
void vtkPVEdgeLengthInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->PortNumber;
}

void vtkPVEdgeLengthInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  stream >> this->PortNumber;
}

//------------------------------------------------------------------------------
void vtkPVEdgeLengthInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PortNumber: " << this->PortNumber << "\n";
  os << indent << "AverageEdgeLength: " << this->GetAverageEdgeLength() << "\n";
}
