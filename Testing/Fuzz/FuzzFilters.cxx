// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// Any mesh, any parameters, any filter: one error and nothing, or a mesh that keeps the promises
/// that need no measuring (Documentation/promises.md). Anything else ends the process.

#include "FuzzedMesh.h"

#include "vtkSharpEdgeExtractor.h"
#include "vtkSharpEdgePreview.h"
#include "vtkSharpEdgeReconstruction.h"
#include "vtkSharpThinningFilter.h"
#include "vtkSharpeningFilter.h"
#include "vtkUSSODFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <set>
#include <string>

using arris::testing::Decisions;

namespace
{
void Require(bool held, const std::string& promise)
{
  if (!held)
  {
    std::fprintf(stderr, "A promise was broken: %s\n", promise.c_str());
    std::abort();
  }
}

class ErrorCount : public vtkCommand
{
public:
  static ErrorCount* New() { return new ErrorCount; }
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
  int Count = 0;
};

vtkSmartPointer<vtkPolyDataAlgorithm> Extractor(Decisions& decisions)
{
  using Filter = vtkSharpEdgeExtractor;
  constexpr void (Filter::*Setters[])(double) = { &Filter::SetFeatureAngle,
    &Filter::SetContinuationAngle, &Filter::SetMaximumAngle, &Filter::SetCornerAngle,
    &Filter::SetNoiseFactor, &Filter::SetGapLength, &Filter::SetTailLength,
    &Filter::SetMinimumLength, &Filter::SetMergeTolerance, &Filter::SetFitTolerance };
  auto filter = vtkSmartPointer<Filter>::New();
  for (int i = decisions.Choice(4); i > 0; --i)
  {
    const int setter = decisions.Choice(static_cast<int>(std::size(Setters)));
    (filter->*Setters[setter])(decisions.Number());
  }
  filter->SetBoundaryEdges(!decisions.Yes());
  filter->SetNonManifoldEdges(!decisions.Yes());
  filter->SetFitPrimitives(!decisions.Yes());
  if (decisions.Choice(4) == 3)
  {
    filter->SetResampleStep(decisions.Number());
  }
  return filter;
}

void SetRegion(Decisions& decisions, vtkSharpRegionAlgorithm* filter)
{
  const int set = decisions.Choice(16);
  if (set & 1)
  {
    filter->SetWindow(decisions.Number());
  }
  if (set & 2)
  {
    filter->SetWindowRatio(decisions.Number());
  }
  if (set & 4)
  {
    filter->SetSharpAngle(decisions.Number());
  }
  if (set & 8)
  {
    filter->SetWindowSearch(decisions.Choice(2));
  }
  if (decisions.Choice(8) == 7)
  {
    vtkNew<vtkPoints> positions;
    positions->SetDataTypeToDouble();
    for (int i = decisions.Choice(4); i > 0; --i)
    {
      const double x = decisions.Number();
      const double y = decisions.Number();
      positions->InsertNextPoint(x, y, decisions.Number());
    }
    decisions.Yes() ? filter->SetPickedPointsSharp(positions)
                    : filter->SetPickedPointsSmooth(positions);
  }
}

template <typename Filter>
vtkSmartPointer<vtkPolyDataAlgorithm> WithRegion(Decisions& decisions)
{
  auto filter = vtkSmartPointer<Filter>::New();
  SetRegion(decisions, filter);
  return filter;
}

vtkSmartPointer<vtkPolyDataAlgorithm> Reconstruction(Decisions& decisions, int method)
{
  auto filter = vtkSmartPointer<vtkSharpEdgeReconstruction>::New();
  filter->SetMethod(method);
  SetRegion(decisions, filter);
  filter->SetDenoise(decisions.Yes());
  filter->SetAllowEdgeFlips(decisions.Yes());
  return filter;
}

vtkSmartPointer<vtkPolyDataAlgorithm> AnyFilter(Decisions& decisions)
{
  switch (decisions.Choice(8))
  {
    case 0:
    case 1:
      return Reconstruction(decisions, vtkSharpEdgeReconstruction::ROBUST);
    case 2:
      return Reconstruction(decisions, vtkSharpEdgeReconstruction::PAPER);
    case 3:
      return Extractor(decisions);
    case 4:
      return WithRegion<vtkUSSODFilter>(decisions);
    case 5:
      return WithRegion<vtkSharpEdgePreview>(decisions);
    case 6:
      return vtkSmartPointer<vtkSharpThinningFilter>::New();
    default:
      return vtkSmartPointer<vtkSharpeningFilter>::New();
  }
}

/// Nothing that the filter has made is NaN or infinite; the input's own arrays may be.
void RequireFinite(vtkFieldData* attributes, const std::set<std::string>& given)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array == nullptr || given.count(array->GetName() != nullptr ? array->GetName() : "") > 0)
    {
      continue;
    }
    for (vtkIdType t = 0; t < array->GetNumberOfTuples(); ++t)
    {
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        Require(std::isfinite(array->GetComponent(t, k)),
          std::string(array->GetName()) + " is finite everywhere");
      }
    }
  }
}

std::set<std::string> NamesOfArrays(vtkPolyData* mesh)
{
  std::set<std::string> names;
  vtkFieldData* const all[] = { mesh->GetPointData(), mesh->GetCellData(), mesh->GetFieldData() };
  for (vtkFieldData* attributes : all)
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      names.insert(attributes->GetArrayName(i));
    }
  }
  return names;
}

void RequireSound(vtkPolyData* output, const std::set<std::string>& given)
{
  for (vtkIdType v = 0; v < output->GetNumberOfPoints(); ++v)
  {
    double p[3];
    output->GetPoint(v, p);
    Require(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]), "points are finite");
  }
  vtkNew<vtkIdList> ids;
  for (vtkCellArray* cells : { output->GetVerts(), output->GetPolys(), output->GetStrips() })
  {
    for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
    {
      cells->GetCellAtId(c, ids);
      for (const vtkIdType id : *ids)
      {
        Require(id >= 0 && id < output->GetNumberOfPoints(), "cells name points that are there");
      }
    }
  }
  RequireFinite(output->GetPointData(), given);
  RequireFinite(output->GetCellData(), given);
  RequireFinite(output->GetFieldData(), given);
}

/// Triangles, and points outside the sharp region, are the input's; but for what the user has
/// allowed.
void RequireKept(vtkPolyData* input, vtkPolyData* output, bool denoised, bool flipped)
{
  Require(output->GetNumberOfPoints() == input->GetNumberOfPoints(), "points are as many");
  const bool triangles =
    !flipped && input->GetNumberOfStrips() == 0 && input->GetPolys()->IsHomogeneous() == 3;
  vtkNew<vtkIdList> before, after;
  for (vtkIdType c = 0; triangles && c < input->GetNumberOfPolys(); ++c)
  {
    input->GetPolys()->GetCellAtId(c, before);
    output->GetPolys()->GetCellAtId(c, after);
    Require(std::equal(before->begin(), before->end(), after->begin(), after->end()),
      "the connectivity is the input's");
  }
  vtkDataArray* region = output->GetPointData()->GetArray("SharpRegion");
  for (vtkIdType v = 0; region != nullptr && !denoised && v < input->GetNumberOfPoints(); ++v)
  {
    double p[3];
    double q[3];
    input->GetPoint(v, p);
    output->GetPoint(v, q);
    Require(region->GetComponent(v, 0) != 0.0 || std::equal(p, p + 3, q),
      "points outside the sharp region stay");
  }
}
}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever(); // errors are counted, not shown
  vtkSMPTools::SetBackend("Sequential");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Decisions decisions(data, size);
  const vtkSmartPointer<vtkPolyDataAlgorithm> filter = AnyFilter(decisions);
  const vtkSmartPointer<vtkPolyData> input = arris::testing::FuzzedMesh(decisions);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(input);

  vtkNew<ErrorCount> errors;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->SetInputData(input);
  filter->Update();

  Require(errors->Count <= 1, "there is one error at most");
  const std::set<std::string> given = NamesOfArrays(before);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* output = filter->GetOutput(port);
    if (output != nullptr)
    {
      Require(errors->Count == 0 || output->GetNumberOfPoints() == 0, "an error gives nothing");
      RequireSound(output, given);
    }
  }
  if (errors->Count == 0)
  {
    auto* extractor = vtkSharpEdgeExtractor::SafeDownCast(filter);
    auto* reconstruction = vtkSharpEdgeReconstruction::SafeDownCast(filter);
    RequireKept(before, extractor != nullptr ? extractor->GetSurfaces() : filter->GetOutput(),
      reconstruction != nullptr && reconstruction->GetDenoise(),
      reconstruction != nullptr && reconstruction->GetAllowEdgeFlips());
  }
  return 0;
}
