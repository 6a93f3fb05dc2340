// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Commands.h"

#include "FeatureFiles.h"
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
  std::string Faces;
  FeatureOptions Features;
  SessionOptions Common;
};

void Regions(const RegionsOptions& options)
{
  CheckMeshOutput(options.Output, Content::MeshWithArrays);
  if (!options.Faces.empty())
  {
    CheckFacesOutput(options.Faces);
  }
  Session session("regions", options.Common);
  session.Report["input"] = options.Input;
  session.Report["output"] = options.Output;

  vtkSmartPointer<vtkPolyData> mesh;
  {
    const auto timer = session.Time("read");
    mesh = ReadMesh(options.Input, session.Progress);
  }
  FeatureOptions features = options.Features;
  features.FitPrimitives = !options.Faces.empty();
  const Features found = FindFeatures(session, mesh, options.Input, features);
  ReportMesh(session, mesh, options.Input);
  ReportFeatures(session, found);
  {
    const auto timer = session.Time("write");
    WriteMesh(found.Surfaces, options.Output, session.Progress);
    session.Say("wrote " + options.Output);
    if (!options.Faces.empty())
    {
      WriteFaces(found, options.Faces);
      session.Say("wrote " + options.Faces);
    }
  }
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
  AddFaces(*command, options->Faces);
  AddFeatureOptions(*command, options->Features);
  AddSessionOptions(*command, options->Common);
  command->footer("Example:\n"
                  "  arris regions sharp.ply -o faces.vtp --faces faces.csv");
  return { command, [options] { Regions(*options); } };
}
}
