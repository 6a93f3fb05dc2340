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
struct SharpenOptions
{
  std::string Input;
  std::string Output;
  std::string Picture;
  RecoveryOptions Recovery;
  SessionOptions Common;
};

void Sharpen(const SharpenOptions& options)
{
  CheckMeshOutput(options.Output, Content::Mesh);
  if (!options.Picture.empty())
  {
    CheckPictureOutput(options.Picture);
  }
  Session session("sharpen", options.Common, !options.Picture.empty());
  session.Report["input"] = options.Input;
  session.Report["output"] = options.Output;

  vtkSmartPointer<vtkPolyData> before;
  {
    const auto timer = session.Time("read");
    before = ReadMesh(options.Input, session.Progress);
  }
  const vtkSmartPointer<vtkPolyData> after =
    Recover(session, before, options.Input, options.Recovery);
  {
    const auto timer = session.Time("write");
    WriteMesh(after, options.Output, session.Progress);
  }
  session.Say("wrote " + options.Output);
  session.WriteReport();
  if (!options.Picture.empty())
  {
    session.Draw(options.Picture,
      [&] {
        DrawPicture(options.Picture, { { "before", before }, { "after", after } }, 2);
      });
    session.Say("drew " + options.Picture);
  }
}
}

Command AddSharpen(CLI::App& program)
{
  const auto options = std::make_shared<SharpenOptions>();
  CLI::App* command = program.add_subcommand("sharpen", "Recover the sharp edges of a mesh");
  AddInput(*command, options->Input, MeshInput);
  AddOutput(*command, options->Output, MeshOutput);
  AddRecoveryOptions(*command, options->Recovery);
  AddPicture(*command, options->Picture, "Draw the mesh before and after; needs an X display");
  AddSessionOptions(*command, options->Common);
  command->footer(
    "Points that coincide exactly are merged in .stl, which cannot share them between triangles,\n"
    "and in .obj where normals or texture coordinates differ between the triangles at a point.\n"
    "In all other formats the mesh is taken as it is. .ply and .stl keep coordinates in single\n"
    "precision.\n\n"
    "Examples:\n"
    "  arris sharpen scan.ply -o sharp.ply\n"
    "  arris sharpen scan.stl -o sharp.vtp --method paper --window-ratio 1 --sharp-angle 35\n"
    "  arris sharpen scan.ply -o sharp.vtp --json report.json --picture sharp.png");
  return { command, [options] { Sharpen(*options); } };
}
}
