// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureStage.h
/// vtkSharpEdgeExtractor as a stage of a session.

#ifndef arris_FeatureStage_h
#define arris_FeatureStage_h

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;
class vtkSharpEdgeExtractor;
class vtkTable;

namespace CLI
{
class App;
}

namespace arris
{
class Session;

/// What vtkSharpEdgeExtractor finds.
struct Features
{
  vtkSmartPointer<vtkPolyData> Curves;
  vtkSmartPointer<vtkPolyData> Corners;
  vtkSmartPointer<vtkPolyData> Surfaces;
  vtkSmartPointer<vtkTable> Faces;
};

/// The parameters of vtkSharpEdgeExtractor, with its defaults.
struct FeatureOptions
{
  double FeatureAngle;
  double ContinuationAngle;
  double MaximumAngle;
  double CornerAngle;
  double NoiseFactor;
  bool NoBoundary = false;
  bool NoNonManifold = false;
  double GapLength;
  double TailLength;
  double MinimumLength;
  double MergeTolerance;
  double FitTolerance;
  double ResampleStep = 0.0;
  bool FitPrimitives = false;

  FeatureOptions();
};

/// --feature-angle, --corner-angle and so on: all but the last two, which not every command has.
void AddFeatureOptions(CLI::App& command, FeatureOptions& options);

/// Runs the filter. `name` is what messages call the mesh.
Features FindFeatures(
  Session& session, vtkPolyData* mesh, const std::string& name, const FeatureOptions& options);

/// Says what was found.
void ReportFeatures(Session& session, const Features& found);
}

#endif
