// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Commands.h"

#include "ComparisonReport.h"
#include "Failure.h"
#include "InOut.h"
#include "MeshFiles.h"
#include "Session.h"
#include "Text.h"
#include "Validators.h"

#include <vtkPolyData.h>

namespace arris
{
namespace
{
struct CompareOptions
{
  std::string Reference;
  std::string Mesh;
  vtkIdType Samples = 0;
  SessionOptions Common;
};

/// Compare, with the files' names in its messages.
Comparison CompareFiles(
  const CompareOptions& options, vtkPolyData* reference, vtkPolyData* mesh, ProgressBar& progress)
{
  try
  {
    return Compare(
      reference, mesh, options.Samples, [&](double fraction) { progress.Show(fraction); });
  }
  catch (const Failure& failure)
  {
    throw Failure(options.Reference + ", " + options.Mesh + ": " + failure.what());
  }
}

void RunCompare(const CompareOptions& options)
{
  Session session("compare", options.Common);
  session.Report["reference"] = options.Reference;
  session.Report["mesh"] = options.Mesh;

  vtkSmartPointer<vtkPolyData> reference;
  vtkSmartPointer<vtkPolyData> mesh;
  {
    const auto timer = session.Time("read");
    reference = ReadMesh(options.Reference, session.Progress);
    mesh = ReadMesh(options.Mesh, session.Progress);
  }
  Comparison comparison;
  {
    const auto timer = session.Time("compare");
    session.Progress.Start("comparing");
    comparison = CompareFiles(options, reference, mesh, session.Progress);
    session.Progress.Clear();
  }
  session.Report.update(ToJson(comparison));
  SayComparison(session, comparison);
  session.Say("%: of the reference's bounding-box diagonal, " + Number(comparison.Diagonal, 6));
  session.WriteReport();
}
}

Command AddCompare(CLI::App& program)
{
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = program.add_subcommand(
    "compare", "Measure how far two meshes are apart: max, mean and RMS, in both directions");
  command->add_option("REFERENCE", options->Reference, MeshInput)->required()->type_name("");
  command->add_option("MESH", options->Mesh, "The mesh to compare with it")
    ->required()
    ->type_name("");
  command
    ->add_option("--samples", options->Samples,
      "About how many points to sample on the faces of each mesh\n(default: 10 a triangle, at "
      "least 200000)")
    ->check(WholeNumber(1e10))
    ->type_name("N");
  AddSessionOptions(*command, options->Common);
  command->footer(
    "Points are spread evenly over the area; mean and RMS are over the area. The maximum also\n"
    "takes in vertices and points on edges. Distances are to the nearest point of a triangle.\n\n"
    "Example:\n"
    "  arris compare truth.stl recovered.ply --json distances.json");
  return { command, [options] { RunCompare(*options); } };
}
}
