// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Stages.h"

#include "ErrorCapture.h"
#include "Failure.h"
#include "Session.h"
#include "Text.h"

#include "Support/Arrays.h"
#include "vtkSharpEdgeReconstruction.h"
#include "vtkUSSODFilter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
using Json = Session::Json;

bool HasPicks(const ClassificationOptions& options)
{
  return !(options.SharpAt.empty() && options.SmoothAt.empty());
}

/// What to do if the filter does not take the mesh or the picked points.
std::string Advice(const ClassificationOptions& options)
{
  return HasPicks(options) ? "pick other points or repair the mesh" : RepairAdvice;
}

vtkSmartPointer<vtkPoints> Points(const std::vector<Position>& positions)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Position& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  return points;
}

void SetClassification(vtkSharpRegionAlgorithm* filter, const ClassificationOptions& options)
{
  if (options.Window)
  {
    filter->SetWindow(*options.Window);
  }
  if (options.WindowRatio)
  {
    filter->SetWindowRatio(*options.WindowRatio);
  }
  if (options.SharpAngle)
  {
    filter->SetSharpAngle(*options.SharpAngle);
  }
  filter->SetWindowSearch(options.WindowSearch == "spatial" ? vtkSharpRegionAlgorithm::SPATIAL
                                                            : vtkSharpRegionAlgorithm::CONNECTED);
  if (options.Patches)
  {
    filter->SetPatchArrayName(*options.Patches);
  }
  if (!options.SharpAt.empty())
  {
    filter->SetPickedPointsSharp(Points(options.SharpAt));
  }
  if (!options.SmoothAt.empty())
  {
    filter->SetPickedPointsSmooth(Points(options.SmoothAt));
  }
}

/// The number of that name in the field data, or 0.
double FieldNumber(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* values = mesh->GetFieldData()->GetArray(name);
  return values != nullptr && values->GetNumberOfTuples() > 0 ? values->GetComponent(0, 0) : 0.0;
}

/// Moves how long a stage took from the mesh, where it would make every file a different one, to
/// the report.
void TakeSeconds(Session& session, vtkPolyData* mesh)
{
  for (const auto& [stage, array] : { std::pair{ "classification", array::ClassificationSeconds },
         std::pair{ "thinning", array::ThinningSeconds },
         std::pair{ "sharpening", array::SharpeningSeconds } })
  {
    if (mesh->GetFieldData()->HasArray(array))
    {
      session.AddSeconds(stage, FieldNumber(mesh, array));
      mesh->GetFieldData()->RemoveArray(array);
    }
  }
}

/// How many points have this value.
vtkIdType CountValue(vtkPolyData* mesh, const char* name, double value)
{
  vtkDataArray* values = mesh->GetPointData()->GetArray(name);
  vtkIdType count = 0;
  for (vtkIdType v = 0; values != nullptr && v < values->GetNumberOfTuples(); ++v)
  {
    count += values->GetComponent(v, 0) == value ? 1 : 0;
  }
  return count;
}

/// The parameters of the paper's method, and of the classification alone.
void ReportWindow(Session& session, vtkPolyData* mesh, const ClassificationOptions& options)
{
  const double lambda = FieldNumber(mesh, array::Lambda);
  const double angle = FieldNumber(mesh, array::SharpAngle);
  const double edge = FieldNumber(mesh, array::AverageEdgeLength);
  Json& parameters = session.Report["parameters"];
  parameters["window"] = lambda;
  parameters["window_ratio"] = edge > 0.0 ? lambda / edge : 0.0;
  parameters["sharp_angle"] = angle;
  parameters["window_search"] = options.WindowSearch;
  parameters["picked"] = HasPicks(options);
  session.Say(std::string(HasPicks(options) ? "by the picked points: " : "") + "window radius " +
    Number(lambda) + ", sharp angle " + Number(angle) + " degrees");
}

/// What the robust method chose, and what became of the vertices of the sharp region.
void ReportAccount(Session& session, vtkPolyData* mesh, const RecoveryOptions& options)
{
  const double lambda = FieldNumber(mesh, array::Lambda);
  const double edge = FieldNumber(mesh, array::AverageEdgeLength);
  const double angle = FieldNumber(mesh, array::SharpAngle);
  Json& parameters = session.Report["parameters"];
  parameters["window"] = lambda;
  parameters["window_ratio"] = edge > 0.0 ? lambda / edge : 0.0;
  double range[2] = { lambda, lambda };
  if (vtkDataArray* windows = mesh->GetPointData()->GetArray(array::Window))
  {
    windows->GetRange(range);
  }
  parameters["window_range"] = { range[0], range[1] };
  parameters["sharp_angle"] = angle;
  parameters["denoise"] = options.Denoise;
  parameters["allow_flips"] = options.AllowFlips;
  parameters["picked"] = HasPicks(options);
  session.Report["recognised"] = { { "roughness", FieldNumber(mesh, array::Roughness) },
    { "rounding", FieldNumber(mesh, array::Rounding) },
    { "bend_triangle_size", FieldNumber(mesh, array::BendTriangleSize) },
    { "bends_are_meant", FieldNumber(mesh, array::BendsAreMeant) > 0.0 } };
  session.Report["edge_flips"] = static_cast<vtkIdType>(FieldNumber(mesh, array::EdgeFlips));
  Json& outcomes = session.Report["outcomes"];
  for (const auto& [outcome, name] :
    { std::pair{ Outcome::Moved, "moved" }, std::pair{ Outcome::Right, "right_already" },
      std::pair{ Outcome::NoFace, "no_face_near" }, std::pair{ Outcome::TooFar, "too_far" },
      std::pair{ Outcome::HeldBack, "held_back" }, std::pair{ Outcome::Smoothed, "smoothed" } })
  {
    outcomes[name] = CountValue(mesh, array::Outcome, static_cast<double>(outcome));
  }
  session.Say(std::string(HasPicks(options) ? "by the picked points: " : "") + "windows of " +
    Number(range[0]) + " to " + Number(range[1]) + ", edges from " + Number(angle) + " degrees");
}

/// What an assembly consists of; a closed mesh is one patch.
void ReportAssembly(Session& session, vtkAssemblyAlgorithm* filter)
{
  session.Report["assembly"] = {
    { "patches", filter->GetNumberOfPatches() },
    { "common_vertices", filter->GetNumberOfCommonVertices() },
    { "junction_edges", filter->GetNumberOfJunctionEdges() },
    { "open_edges", filter->GetNumberOfOpenEdges() },
    { "one_sided_patches", filter->GetNumberOfOneSidedPatches() },
  };
  if (filter->GetNumberOfCommonVertices() > 0)
  {
    session.Say("assembly: " + Count(filter->GetNumberOfPatches(), "patch", "patches") + ", " +
      Count(filter->GetNumberOfCommonVertices(), "common vertex", "common vertices") + ", " +
      Count(filter->GetNumberOfJunctionEdges(), "junction edge", "junction edges"));
  }
}

/// The sharp region of any method.
void ReportRegion(Session& session, vtkPolyData* mesh)
{
  const double edge = FieldNumber(mesh, array::AverageEdgeLength);
  const vtkIdType sharp = CountValue(mesh, array::SharpRegion, 1.0);
  session.Report["average_edge_length"] = edge;
  session.Report["counts"]["sharp_vertices"] = sharp;
  session.Say("average edge length " + Number(edge));
  session.Say("sharp region: " + Count(sharp, "vertex", "vertices"));
}

void ReportSkeleton(Session& session, vtkPolyData* mesh)
{
  const vtkIdType branch = CountValue(mesh, array::SkeletonRole, 1.0);
  const vtkIdType joint = CountValue(mesh, array::SkeletonRole, 2.0);
  const vtkIdType end = CountValue(mesh, array::SkeletonRole, 3.0);
  session.Report["counts"]["skeleton_vertices"] = {
    { "branch", branch },
    { "joint", joint },
    { "end", end },
  };
  session.Say("skeleton: " + Count(branch, "branch vertex", "branch vertices") + ", " +
    Count(joint, "joint", "joints") + ", " + Count(end, "end", "ends"));
}

void ReportDisplacement(Session& session, vtkPolyData* mesh)
{
  vtkDataArray* displacement = mesh->GetPointData()->GetArray(array::Displacement);
  double largest = 0.0;
  double sum = 0.0;
  vtkIdType moved = 0;
  for (vtkIdType v = 0; displacement != nullptr && v < displacement->GetNumberOfTuples(); ++v)
  {
    const double length = std::hypot(displacement->GetComponent(v, 0),
      displacement->GetComponent(v, 1), displacement->GetComponent(v, 2));
    largest = std::max(largest, length);
    sum += length;
    moved += length > 0.0 ? 1 : 0;
  }
  const double mean = moved > 0 ? sum / static_cast<double>(moved) : 0.0;
  session.Report["counts"]["moved_vertices"] = moved;
  session.Report["displacement"] = { { "largest", largest }, { "mean_of_moved", mean } };
  session.Say("moved: " + Count(moved, "vertex", "vertices") + ", by " + Number(mean) +
    " on average, " + Number(largest) + " at most");
}
}

void RunStage(Session& session, vtkAlgorithm* filter, const std::string& stage,
  const std::string& name, const std::string& advice)
{
  const ErrorCapture capture;
  session.Progress.Follow(stage, filter);
  filter->Update();
  session.Progress.Clear();
  const std::string cause = capture.FirstError();
  if (!cause.empty())
  {
    throw Failure(name, cause, advice);
  }
  const std::string warning = capture.FirstWarning();
  if (!warning.empty())
  {
    session.Warn(name + ": " + warning);
  }
}

void ReportMesh(Session& session, vtkPolyData* mesh, const std::string& name)
{
  session.Report["counts"]["vertices"] = mesh->GetNumberOfPoints();
  session.Report["counts"]["triangles"] = mesh->GetNumberOfPolys();
  session.Say(name + ": " + Count(mesh->GetNumberOfPoints(), "vertex", "vertices") + ", " +
    Count(mesh->GetNumberOfPolys(), "triangle", "triangles"));
}

vtkSmartPointer<vtkPolyData> Classify(Session& session, vtkPolyData* mesh, const std::string& name,
  const ClassificationOptions& options)
{
  vtkNew<vtkUSSODFilter> filter;
  filter->SetInputData(mesh);
  SetClassification(filter, options);
  RunStage(session, filter, "classifying", name, Advice(options));
  vtkSmartPointer<vtkPolyData> result = filter->GetOutput();
  TakeSeconds(session, result);
  ReportMesh(session, result, name);
  ReportAssembly(session, filter);
  ReportWindow(session, result, options);
  ReportRegion(session, result);
  return result;
}

vtkSmartPointer<vtkPolyData> Recover(
  Session& session, vtkPolyData* mesh, const std::string& name, const RecoveryOptions& options)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetInputData(mesh);
  filter->SetMethod(options.Method == "paper" ? vtkSharpEdgeReconstruction::PAPER
                                              : vtkSharpEdgeReconstruction::ROBUST);
  SetClassification(filter, options);
  filter->SetDenoise(options.Denoise);
  filter->SetAllowEdgeFlips(options.AllowFlips);
  session.Report["parameters"]["method"] = options.Method;
  RunStage(session, filter, "recovering", name, Advice(options));
  vtkSmartPointer<vtkPolyData> result = filter->GetOutput();
  TakeSeconds(session, result);
  ReportMesh(session, result, name);
  ReportAssembly(session, filter);
  if (options.Method == "paper")
  {
    ReportWindow(session, result, options);
  }
  else
  {
    ReportAccount(session, result, options);
  }
  ReportRegion(session, result);
  ReportSkeleton(session, result);
  ReportDisplacement(session, result);
  return result;
}
}
