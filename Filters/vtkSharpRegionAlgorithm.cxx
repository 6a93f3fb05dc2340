// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpRegionAlgorithm.h"

#include "Core/Geometry.h"
#include "Support/Classification.h"
#include "Support/Parameters.h"
#include "Support/PickedPoints.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>

#include <algorithm>

namespace
{
enum InputPort
{
  SharpPort = 1,
  SmoothPort = 2,
  NumberOfPorts = 3
};

std::string ReadPicks(vtkInformationVector* selection, vtkPoints* positions, vtkPolyData* input,
  const arris::Surface& surface, arris::PickedPoints& picked)
{
  const std::string problem = arris::AddSelection(vtkSelection::GetData(selection), input, picked);
  return problem.empty() ? arris::AddPositions(positions, surface, picked) : problem;
}
}

//------------------------------------------------------------------------------
vtkSharpRegionAlgorithm::vtkSharpRegionAlgorithm()
  : WindowRatio(arris::DefaultWindowRatio)
  , SharpAngle(arris::DefaultSharpAngle)
  , Classifier(std::make_unique<arris::Classification>())
{
  this->SetNumberOfInputPorts(NumberOfPorts);
}

vtkSharpRegionAlgorithm::~vtkSharpRegionAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkSharpRegionAlgorithm::SetPickedPointsSharp(vtkPoints* positions)
{
  if (this->PickedPointsSharp != positions)
  {
    this->PickedPointsSharp = positions;
    this->Modified();
  }
}

void vtkSharpRegionAlgorithm::SetPickedPointsSmooth(vtkPoints* positions)
{
  if (this->PickedPointsSmooth != positions)
  {
    this->PickedPointsSmooth = positions;
    this->Modified();
  }
}

void vtkSharpRegionAlgorithm::SetPickedPointsSharpConnection(vtkAlgorithmOutput* selection)
{
  this->SetInputConnection(SharpPort, selection);
}

void vtkSharpRegionAlgorithm::SetPickedPointsSharpData(vtkSelection* selection)
{
  this->SetInputData(SharpPort, selection);
}

void vtkSharpRegionAlgorithm::RemovePickedPointsSharpInput()
{
  this->SetInputConnection(SharpPort, nullptr);
}

void vtkSharpRegionAlgorithm::SetPickedPointsSmoothConnection(vtkAlgorithmOutput* selection)
{
  this->SetInputConnection(SmoothPort, selection);
}

void vtkSharpRegionAlgorithm::SetPickedPointsSmoothData(vtkSelection* selection)
{
  this->SetInputData(SmoothPort, selection);
}

void vtkSharpRegionAlgorithm::RemovePickedPointsSmoothInput()
{
  this->SetInputConnection(SmoothPort, nullptr);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkSharpRegionAlgorithm::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkPoints* positions : { this->GetPickedPointsSharp(), this->GetPickedPointsSmooth() })
  {
    time = positions != nullptr ? std::max(time, positions->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkSharpRegionAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port != SharpPort && port != SmoothPort)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkSharpRegionAlgorithm::ProblemWithParameters() const
{
  return arris::FirstProblem(
    { arris::ProblemWithWindow(this->Window, this->WindowRatio, this->WindowSearch) },
    [this] { return arris::ProblemWithAngle("SharpAngle", this->SharpAngle); });
}

//------------------------------------------------------------------------------
std::string vtkSharpRegionAlgorithm::ChooseParameters(vtkInformationVector** inputVector,
  const arris::Surface& surface, arris::ClassificationParameters& parameters)
{
  parameters.WindowRadius = arris::WindowRadius(this->Window,
    this->WindowRatio > 0.0 ? this->WindowRatio : arris::DefaultWindowRatio,
    surface.AverageEdgeLength);
  parameters.SharpAngle = this->SharpAngle > 0.0 ? this->SharpAngle : arris::DefaultSharpAngle;
  parameters.Search = static_cast<arris::WindowSearch>(this->WindowSearch);

  arris::PickedPoints sharp;
  arris::PickedPoints smooth;
  if (!surface.Triangulation.Triangles.empty())
  {
    vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
    std::string problem = arris::FirstProblem(
      { ReadPicks(inputVector[SharpPort], this->PickedPointsSharp, input, surface, sharp) },
      [&] {
        return ReadPicks(inputVector[SmoothPort], this->PickedPointsSmooth, input, surface, smooth);
      });
    if (!problem.empty())
    {
      return problem;
    }
  }
  this->PointsArePicked = !(sharp.Vertices.empty() && smooth.Vertices.empty());
  std::string problem = this->PointsArePicked
    ? arris::FollowPickedPoints(surface, sharp, smooth, parameters)
    : std::string();
  this->SetUsed(parameters.WindowRadius, surface.AverageEdgeLength, parameters.SharpAngle);
  return problem;
}

//------------------------------------------------------------------------------
void vtkSharpRegionAlgorithm::SetUsed(double window, double averageEdgeLength, double sharpAngle)
{
  this->UsedWindow = window;
  this->UsedWindowRatio = averageEdgeLength > 0.0 ? window / averageEdgeLength : 0.0;
  this->UsedSharpAngle = sharpAngle;
  this->Kappa = window > 0.0 ? arris::DifferenceOfAngle(sharpAngle) / window : 0.0;
}

//------------------------------------------------------------------------------
void vtkSharpRegionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Window: " << this->Window << "\n";
  os << indent << "WindowRatio: " << this->WindowRatio << "\n";
  os << indent << "SharpAngle: " << this->SharpAngle << "\n";
  os << indent << "WindowSearch: " << this->WindowSearch << "\n";
  os << indent << "PickedPointsSharp: " << this->PickedPointsSharp.Get() << "\n";
  os << indent << "PickedPointsSmooth: " << this->PickedPointsSmooth.Get() << "\n";
  os << indent << "UsedWindow: " << this->UsedWindow << "\n";
  os << indent << "UsedWindowRatio: " << this->UsedWindowRatio << "\n";
  os << indent << "UsedSharpAngle: " << this->UsedSharpAngle << "\n";
  os << indent << "Kappa: " << this->Kappa << "\n";
}
