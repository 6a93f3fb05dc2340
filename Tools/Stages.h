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

class vtkAlgorithm;
class vtkPolyData;

namespace arris
{
class Session;

constexpr const char* RepairAdvice = "repair the mesh first";

/// Updates a filter; its error, if it has one, as a Failure. `name` is what messages call the mesh,
/// `advice` what to do.
void RunStage(Session& session, vtkAlgorithm* filter, const std::string& stage,
  const std::string& name, const std::string& advice = RepairAdvice);

/// Says how large the mesh is.
void ReportMesh(Session& session, vtkPolyData* mesh, const std::string& name);

/// vtkUSSODFilter. `name` is what messages call the mesh.
vtkSmartPointer<vtkPolyData> Classify(Session& session, vtkPolyData* mesh, const std::string& name,
  const ClassificationOptions& options);

/// vtkSharpEdgeReconstruction.
vtkSmartPointer<vtkPolyData> Recover(
  Session& session, vtkPolyData* mesh, const std::string& name, const RecoveryOptions& options);
}

#endif
