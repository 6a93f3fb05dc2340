// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Commands.h"

#include "InOut.h"
#include "MeshFiles.h"
#include "Picture.h"
#include "Session.h"
#include "Stages.h"

#include <vtkPolyData.h>

namespace arris
{
namespace
{
struct EdgesOptions
{
  std::string Input;
  std::string Output;
  std::string Corners;
  std::string Picture;
  FeatureOptions Features;
  SessionOptions Common;
};

void Edges(const EdgesOptions& options)
{
  CheckMeshOutput(options.Output, Content::Curves);
  if (!options.Corners.empty())
  {
    CheckMeshOutput(options.Corners, Content::Curves);
  }
  if (!options.Picture.empty())
  {
    CheckPictureOutput(options.Picture);
  }
  Session session("edges", options.Common, !options.Picture.empty());
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
    WriteMesh(found.Curves, options.Output, session.Progress);
    session.Say("wrote " + options.Output);
    if (!options.Corners.empty())
    {
      WriteMesh(found.Corners, options.Corners, session.Progress);
      session.Say("wrote " + options.Corners);
    }
  }
  session.WriteReport();
  if (!options.Picture.empty())
  {
    session.Draw(options.Picture,
      [&] {
        DrawPicture(options.Picture, { { "", mesh, found.Curves, found.Corners } });
      });
    session.Say("drew " + options.Picture);
  }
}
}

Command AddEdges(CLI::App& program)
{
  const auto options = std::make_shared<EdgesOptions>();
  CLI::App* command =
    program.add_subcommand("edges", "Extract the sharp feature curves of a mesh, and its corners");
  AddInput(*command, options->Input, MeshInput);
  AddOutput(*command, options->Output, "Where the curves go: .vtp, .vtk or .obj");
  command->add_option("--corners", options->Corners, "Where the corners go: .vtp, .vtk or .obj")
    ->type_name("FILE");
  AddFeatureOptions(*command, options->Features);
  AddPicture(*command, options->Picture, "Draw the mesh with its curves; needs an X display");
  AddSessionOptions(*command, options->Common);
  command->footer("Example:\n"
                  "  arris edges sharp.ply -o curves.vtp --corners corners.vtp --feature-angle 20");
  return { command, [options] { Edges(*options); } };
}
}
