// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureStage.h"

#include "Session.h"
#include "Stages.h"
#include "Text.h"
#include "Validators.h"

#include "Support/Arrays.h"
#include "vtkSharpEdgeExtractor.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <CLI/CLI.hpp>

namespace arris
{
namespace
{
using Json = Session::Json;

constexpr const char* Group = "Features";

void AddAngle(
  CLI::App& command, const std::string& name, double& value, const std::string& description)
{
  command.add_option(name, value, description)->check(Angle())->type_name("DEGREES")->group(Group);
}

/// A length of which a negative one, as by default, is found automatically.
void AddLength(
  CLI::App& command, const std::string& name, double& value, const std::string& description)
{
  command.add_option(name, value, description)
    ->check(NotNegative())
    ->type_name("LENGTH")
    ->group(Group);
}
}

FeatureOptions::FeatureOptions()
{
  vtkNew<vtkSharpEdgeExtractor> filter;
  this->FeatureAngle = filter->GetFeatureAngle();
  this->ContinuationAngle = filter->GetContinuationAngle();
  this->MaximumAngle = filter->GetMaximumAngle();
  this->CornerAngle = filter->GetCornerAngle();
  this->NoiseFactor = filter->GetNoiseFactor();
  this->GapLength = filter->GetGapLength();
  this->TailLength = filter->GetTailLength();
  this->MinimumLength = filter->GetMinimumLength();
  this->MergeTolerance = filter->GetMergeTolerance();
  this->FitTolerance = filter->GetFitTolerance();
}

void AddFeatureOptions(CLI::App& command, FeatureOptions& options)
{
  AddAngle(command, "--feature-angle", options.FeatureAngle,
    "Edges whose triangles' normals differ by more are\nfeatures (default " +
      Number(options.FeatureAngle) + ")");
  AddAngle(command, "--continuation-angle", options.ContinuationAngle,
    "And those above this that go on where a feature ends\n(default half of --feature-angle)");
  AddAngle(command, "--maximum-angle", options.MaximumAngle,
    "Edges above this are no features (default " + Number(options.MaximumAngle) + ")");
  AddAngle(command, "--corner-angle", options.CornerAngle,
    "Curves that turn by more are split there\n(default " + Number(options.CornerAngle) +
      "; 180 for never)");
  command
    .add_option("--noise-factor", options.NoiseFactor,
      "Judge edges by both sides' mean normals where the mesh\nfolds up and down by more than "
      "their angle over this\n(default " +
        Number(options.NoiseFactor) + "; 0: every fold is shape)")
    ->check(NotNegative())
    ->type_name("R")
    ->group(Group);
  command.add_flag("--no-boundary", options.NoBoundary, "Leave out the boundary of the mesh")
    ->group(Group);
  command
    .add_flag("--no-non-manifold", options.NoNonManifold,
      "Leave out edges where three or more triangles meet")
    ->group(Group);
  AddLength(command, "--gap", options.GapLength,
    "Close gaps up to this (default: one average edge; 0: none)");
  AddLength(command, "--tail", options.TailLength,
    "Cut tails shorter than this (default: two average edges;\n0: none)");
  AddLength(command, "--minimum-length", options.MinimumLength,
    "Drop curves shorter than this (default 0: none)");
  command
    .add_option("--merge-tolerance", options.MergeTolerance,
      "Points on open edges this near are one, as a part of the\nmesh's diagonal (default " +
        Number(options.MergeTolerance) + ")")
    ->check(NotNegative())
    ->type_name("R")
    ->group(Group);
}

Features FindFeatures(
  Session& session, vtkPolyData* mesh, const std::string& name, const FeatureOptions& options)
{
  const auto timer = session.Time("extraction");
  vtkNew<vtkSharpEdgeExtractor> filter;
  filter->SetInputData(mesh);
  filter->SetFeatureAngle(options.FeatureAngle);
  filter->SetContinuationAngle(options.ContinuationAngle);
  filter->SetMaximumAngle(options.MaximumAngle);
  filter->SetCornerAngle(options.CornerAngle);
  filter->SetNoiseFactor(options.NoiseFactor);
  filter->SetBoundaryEdges(!options.NoBoundary);
  filter->SetNonManifoldEdges(!options.NoNonManifold);
  filter->SetGapLength(options.GapLength);
  filter->SetTailLength(options.TailLength);
  filter->SetMinimumLength(options.MinimumLength);
  filter->SetMergeTolerance(options.MergeTolerance);
  filter->SetResampleStep(options.ResampleStep);
  filter->SetFitPrimitives(options.FitPrimitives);
  filter->SetFitTolerance(options.FitTolerance);
  Json& parameters = session.Report["parameters"];
  parameters["feature_angle"] = options.FeatureAngle;
  parameters["continuation_angle"] = options.ContinuationAngle;
  parameters["maximum_angle"] = options.MaximumAngle;
  parameters["corner_angle"] = options.CornerAngle;
  parameters["noise_factor"] = options.NoiseFactor;
  parameters["boundary"] = !options.NoBoundary;
  parameters["non_manifold"] = !options.NoNonManifold;
  parameters["gap"] = options.GapLength;
  parameters["tail"] = options.TailLength;
  parameters["minimum_length"] = options.MinimumLength;
  parameters["merge_tolerance"] = options.MergeTolerance;
  RunStage(session, filter, "extracting", name);
  return { filter->GetOutput(), filter->GetCorners(), filter->GetSurfaces(), filter->GetFaces() };
}

void ReportFeatures(Session& session, const Features& found)
{
  vtkDataArray* lengths = found.Curves->GetCellData()->GetArray(array::CurveLength);
  double length = 0.0;
  for (vtkIdType i = 0; lengths != nullptr && i < lengths->GetNumberOfTuples(); ++i)
  {
    length += lengths->GetComponent(i, 0);
  }
  const vtkIdType surfaces = found.Faces->GetNumberOfRows();
  Json& counts = session.Report["counts"];
  counts["curves"] = found.Curves->GetNumberOfCells();
  counts["corners"] = found.Corners->GetNumberOfPoints();
  counts["surfaces"] = surfaces;
  session.Report["curve_length"] = length;
  session.Say("features: " + Count(found.Curves->GetNumberOfCells(), "curve", "curves") +
    " of length " + Number(length, 6) + ", " +
    Count(found.Corners->GetNumberOfPoints(), "corner", "corners") + ", " +
    Count(surfaces, "surface", "surfaces"));
}
}
