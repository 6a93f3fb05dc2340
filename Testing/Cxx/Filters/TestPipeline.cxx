// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkCallbackCommand.h>

#include <sstream>

using namespace arris::testing;

namespace
{
/// Counts how often a filter executes.
class Runs
{
public:
  explicit Runs(vtkAlgorithm* filter)
  {
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(this);
    count->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { ++static_cast<Runs*>(self)->Count; });
    filter->AddObserver(vtkCommand::StartEvent, count);
  }
  int Count = 0;
};
}

class Pipeline : public EachFilter
{
};

TEST_P(Pipeline, RunsAgainOnlyWhenSomethingChanged)
{
  const auto input = ReadyMesh(16);
  Runs runs(this->Filter);
  this->Filter->SetInputData(input);
  this->Filter->Update();
  this->Filter->Update();
  EXPECT_EQ(runs.Count, 1);
  input->Modified();
  this->Filter->Update();
  EXPECT_EQ(runs.Count, 2);
  this->Filter->Modified();
  this->Filter->Update();
  EXPECT_EQ(runs.Count, 3);
}

TEST_P(Pipeline, GivesTheSameEachTime)
{
  const auto input = ReadyMesh(16);
  const auto first = Execute(this->Filter, input);
  this->Filter->Modified();
  ExpectIdentical(Execute(this->Filter, input), first);
}

TEST_P(Pipeline, PrintsItself)
{
  std::ostringstream text;
  this->Filter->Print(text);
  EXPECT_NE(text.str().find(this->Filter->GetClassName()), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Filters, Pipeline, AllFilters(), FilterName);

namespace
{
/// Sets a value, expects a new run, sets it once more, expects none; and finds it printed.
template <typename Filter, typename Value>
void ExpectProperty(const char* name, void (Filter::*set)(Value), Value (Filter::*get)(),
  Value byDefault, Value other)
{
  const auto input = ReadyMesh(16);
  vtkNew<Filter> filter;
  EXPECT_NEAR((filter->*get)(), byDefault, 1e-6) << name;
  Runs runs(filter);
  filter->SetInputData(input);
  filter->Update();
  (filter->*set)(other);
  filter->Update();
  EXPECT_EQ((filter->*get)(), other) << name;
  EXPECT_EQ(runs.Count, 2) << name;
  (filter->*set)(other);
  filter->Update();
  EXPECT_EQ(runs.Count, 2) << name << " was not changed";
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find(std::string(name) + ": "), std::string::npos) << name;
}

template <typename Filter>
void ExpectClassificationProperties(double ratio, double angle)
{
  ExpectProperty<Filter, double>("Window", &Filter::SetWindow, &Filter::GetWindow, 0.0, 0.2);
  ExpectProperty<Filter, double>(
    "WindowRatio", &Filter::SetWindowRatio, &Filter::GetWindowRatio, ratio, 1.5);
  ExpectProperty<Filter, double>(
    "SharpAngle", &Filter::SetSharpAngle, &Filter::GetSharpAngle, angle, 30.0);
  ExpectProperty<Filter, int>("WindowSearch", &Filter::SetWindowSearch, &Filter::GetWindowSearch,
    Filter::CONNECTED, Filter::SPATIAL);
}
}

TEST(Properties, OfUSSOD)
{
  ExpectClassificationProperties<vtkUSSODFilter>(0.75, 41.409622);
}

TEST(Properties, OfReconstruction)
{
  using Filter = vtkSharpEdgeReconstruction;
  ExpectClassificationProperties<Filter>(0.0, 0.0); // both left to the method
  ExpectProperty<Filter, int>(
    "Method", &Filter::SetMethod, &Filter::GetMethod, Filter::ROBUST, Filter::PAPER);
  ExpectProperty<Filter, bool>("Denoise", &Filter::SetDenoise, &Filter::GetDenoise, false, true);
  ExpectProperty<Filter, bool>(
    "AllowEdgeFlips", &Filter::SetAllowEdgeFlips, &Filter::GetAllowEdgeFlips, false, true);
}

TEST(Properties, OfSharpening)
{
  using Filter = vtkSharpeningFilter;
  ExpectProperty<Filter, double>("Window", &Filter::SetWindow, &Filter::GetWindow, 0.0, 0.2);
  ExpectProperty<Filter, double>(
    "WindowRatio", &Filter::SetWindowRatio, &Filter::GetWindowRatio, 0.75, 1.5);
}

TEST(Properties, OfTheExtractor)
{
  using Filter = vtkSharpEdgeExtractor;
  ExpectProperty<Filter, double>(
    "FeatureAngle", &Filter::SetFeatureAngle, &Filter::GetFeatureAngle, 30.0, 20.0);
  ExpectProperty<Filter, double>(
    "CornerAngle", &Filter::SetCornerAngle, &Filter::GetCornerAngle, 60.0, 90.0);
  ExpectProperty<Filter, double>(
    "ContinuationAngle", &Filter::SetContinuationAngle, &Filter::GetContinuationAngle, 0.0, 20.0);
  ExpectProperty<Filter, double>(
    "MaximumAngle", &Filter::SetMaximumAngle, &Filter::GetMaximumAngle, 180.0, 170.0);
  ExpectProperty<Filter, double>(
    "NoiseFactor", &Filter::SetNoiseFactor, &Filter::GetNoiseFactor, 30.0, 5.0);
  ExpectProperty<Filter, bool>(
    "BoundaryEdges", &Filter::SetBoundaryEdges, &Filter::GetBoundaryEdges, true, false);
  ExpectProperty<Filter, bool>(
    "NonManifoldEdges", &Filter::SetNonManifoldEdges, &Filter::GetNonManifoldEdges, true, false);
  ExpectProperty<Filter, double>(
    "GapLength", &Filter::SetGapLength, &Filter::GetGapLength, -1.0, 0.1);
  ExpectProperty<Filter, double>(
    "TailLength", &Filter::SetTailLength, &Filter::GetTailLength, -1.0, 0.1);
  ExpectProperty<Filter, double>(
    "MinimumLength", &Filter::SetMinimumLength, &Filter::GetMinimumLength, 0.0, 0.1);
  ExpectProperty<Filter, double>(
    "MergeTolerance", &Filter::SetMergeTolerance, &Filter::GetMergeTolerance, 1e-6, 0.0);
  ExpectProperty<Filter, double>(
    "ResampleStep", &Filter::SetResampleStep, &Filter::GetResampleStep, 0.0, 0.1);
  ExpectProperty<Filter, bool>(
    "FitPrimitives", &Filter::SetFitPrimitives, &Filter::GetFitPrimitives, true, false);
  ExpectProperty<Filter, double>(
    "FitTolerance", &Filter::SetFitTolerance, &Filter::GetFitTolerance, 0.03, 0.1);
}
