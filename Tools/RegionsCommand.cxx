// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Commands.h"

#include "InOut.h"
#include "MeshFiles.h"
#include "Session.h"
#include "Stages.h"

#include <vtkPolyData.h>

namespace arris
{
namespace
{
struct RegionsOptions
{
  std::string Input;
  std::string Output;
  FeatureOptions Features;
  SessionOptions Common;
};

void Regions(const RegionsOptions& options)
{
  CheckMeshOutput(options.Output, Content::MeshWithArrays);
  Session session("regions", options.Common);
  session.Report["input"] = options.Input;
  session.Report["output"] = options.Output;

  vtkSmartPointer<vtkPolyData> mesh;
  {
    const auto timer = session.Time("read");
    mesh = ReadMesh(options.Input, session.Progress);
  }
  const Features found = FindFeatures(session, mesh, options.Input, options.Features);
  ReportMesh(session, mesh, options.Input);
  ReportFeatures(session, found);
  {
    const auto timer = session.Time("write");
    WriteMesh(found.Surfaces, options.Output, session.Progress);
  }
  session.Say("wrote " + options.Output);
  session.WriteReport();
}
}

Command AddRegions(CLI::App& program)
{
  const auto options = std::make_shared<RegionsOptions>();
  CLI::App* command = program.add_subcommand(
    "regions", "Number the smooth faces between the feature curves of a mesh: array SurfaceId");
  AddInput(*command, options->Input, MeshInput);
  AddOutput(*command, options->Output, "Where to: .vtp or .vtk, which hold arrays");
  AddFeatureOptions(*command, options->Features);
  AddSessionOptions(*command, options->Common);
  command->footer("Example:\n"
                  "  arris regions sharp.ply -o faces.vtp --feature-angle 20");
  return { command, [options] { Regions(*options); } };
}
}
