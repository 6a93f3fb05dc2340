// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Stages.h
/// The filters as stages of a session: run with progress, their errors as Failures, what they found
/// in the report.

#ifndef arris_Stages_h
#define arris_Stages_h

#include "RecoveryOptions.h"

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

namespace arris
{
class Session;

/// Says how large the mesh is.
void ReportMesh(Session& session, vtkPolyData* mesh, const std::string& name);

/// vtkUSSODFilter. `name` is what messages call the mesh.
vtkSmartPointer<vtkPolyData> Classify(Session& session, vtkPolyData* mesh, const std::string& name,
  const ClassificationOptions& options);

/// vtkSharpEdgeReconstruction.
vtkSmartPointer<vtkPolyData> Recover(
  Session& session, vtkPolyData* mesh, const std::string& name, const RecoveryOptions& options);

/// What vtkSharpEdgeExtractor finds.
struct Features
{
  vtkSmartPointer<vtkPolyData> Curves;
  vtkSmartPointer<vtkPolyData> Corners;
  vtkSmartPointer<vtkPolyData> Surfaces;
};

struct FeatureOptions
{
  double FeatureAngle;
  double CornerAngle;

  FeatureOptions();
};

/// --feature-angle, --corner-angle.
void AddFeatureOptions(CLI::App& command, FeatureOptions& options);

/// vtkSharpEdgeExtractor.
Features FindFeatures(
  Session& session, vtkPolyData* mesh, const std::string& name, const FeatureOptions& options);

/// Says what was found.
void ReportFeatures(Session& session, const Features& found);
}

#endif
