// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Commands.h"

#include "FeatureFiles.h"
#include "InOut.h"
#include "MeshFiles.h"
#include "Picture.h"
#include "Session.h"
#include "Stages.h"
#include "Validators.h"

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
  std::string Faces;
  std::string Picture;
  FeatureOptions Features;
  SessionOptions Common;
};

void Edges(const EdgesOptions& options)
{
  CheckCurvesOutput(options.Output);
  if (!options.Corners.empty())
  {
    CheckCornersOutput(options.Corners);
  }
  if (!options.Faces.empty())
  {
    CheckFacesOutput(options.Faces);
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
  FeatureOptions features = options.Features;
  features.FitPrimitives = !options.Faces.empty();
  session.Report["parameters"]["resample"] = features.ResampleStep;
  const Features found = FindFeatures(session, mesh, options.Input, features);
  ReportMesh(session, mesh, options.Input);
  ReportFeatures(session, found);
  {
    const auto timer = session.Time("write");
    WriteCurves(found, options.Output, session.Progress);
    session.Say("wrote " + options.Output);
    if (!options.Corners.empty())
    {
      WriteCorners(found, options.Corners, session.Progress);
      session.Say("wrote " + options.Corners);
    }
    if (!options.Faces.empty())
    {
      WriteFaces(found, options.Faces);
      session.Say("wrote " + options.Faces);
    }
  }
  session.WriteReport();
  if (!options.Picture.empty())
  {
    session.Draw(options.Picture,
      [&] {
        DrawPicture(options.Picture, { { "", mesh, found.Curves, found.Corners, true } });
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
  AddOutput(*command, options->Output,
    "Where the curves go: .vtp or .vtk with all arrays; .obj;\n.eMesh (OpenFOAM); .csv with a row "
    "a curve");
  command
    ->add_option("--corners", options->Corners, "Where the corners go: .vtp, .vtk, .obj or .csv")
    ->type_name("FILE");
  AddFaces(*command, options->Faces);
  command
    ->add_option("--resample", options->Features.ResampleStep,
      "Put the curves' points at about this distance (default:\nthe mesh's own points)")
    ->check(Positive())
    ->type_name("STEP");
  AddFeatureOptions(*command, options->Features);
  AddPicture(*command, options->Picture, "Draw the mesh with its curves; needs an X display");
  AddSessionOptions(*command, options->Common);
  command->footer("Examples:\n"
                  "  arris edges part.stl -o curves.vtp --picture curves.png\n"
                  "  arris edges part.stl -o part.eMesh --feature-angle 20\n"
                  "  arris edges part.stl -o curves.csv --corners corners.csv --faces faces.csv");
  return { command, [options] { Edges(*options); } };
}
}
