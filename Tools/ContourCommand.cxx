// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Commands.h"

#include "Contour.h"
#include "InOut.h"
#include "MeshFiles.h"
#include "Picture.h"
#include "Session.h"
#include "Stages.h"
#include "Validators.h"
#include "VolumeFiles.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

namespace arris
{
namespace
{
struct ContourOptions
{
  std::string Input;
  double Value = 0.0;
  std::string InsideWord = "auto";
  bool Sharpen = true;
  std::string Output;
  std::string Picture;
  RecoveryOptions Recovery;
  SessionOptions Common;
};

Inside InsideOf(const std::string& word)
{
  return word == "above" ? Inside::Above : word == "below" ? Inside::Below : Inside::Auto;
}

void RunContour(const ContourOptions& options)
{
  CheckMeshOutput(options.Output, Content::Mesh);
  if (!options.Picture.empty())
  {
    CheckPictureOutput(options.Picture);
  }
  Session session("contour", options.Common, !options.Picture.empty());
  session.Report["input"] = options.Input;
  session.Report["output"] = options.Output;
  session.Report["parameters"]["value"] = options.Value;
  session.Report["parameters"]["inside"] = options.InsideWord;

  vtkSmartPointer<vtkImageData> volume;
  {
    const auto timer = session.Time("read");
    volume = ReadVolume(options.Input, session.Progress);
  }
  vtkSmartPointer<vtkPolyData> before;
  {
    const auto timer = session.Time("contour");
    before =
      Contour(volume, options.Value, InsideOf(options.InsideWord), options.Input, session.Progress);
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

Command AddContour(CLI::App& program)
{
  const auto options = std::make_shared<ContourOptions>();
  CLI::App* command = program.add_subcommand(
    "contour", "Make an iso-surface of a volume and recover its sharp edges");
  command->add_option("VOLUME", options->Input, "The volume: .vti .mha .mhd .nrrd .vtk")
    ->required()
    ->type_name("");
  command->add_option("--value", options->Value, "The value that the volume has on the surface")
    ->required()
    ->check(Finite())
    ->type_name("V");
  AddOutput(*command, options->Output, MeshOutput);
  command
    ->add_option("--inside", options->InsideWord,
      "Where the solid is: above or below the value; auto\n(default): where fewer samples on the "
      "border of the volume\nare")
    ->check(OneOf({ "auto", "above", "below" }))
    ->type_name("auto|above|below");
  AddRecoveryOptions(*command, options->Recovery);
  AddPicture(*command, options->Picture, "Draw the surface before and after; needs an X display");
  AddSessionOptions(*command, options->Common);
  command->footer(
    "Triangles face outwards, away from the solid (--inside). The surface ends at the border of\n"
    "the volume. Of values with several components the first counts.\n\n"
    "Examples:\n"
    "  arris contour part.mha --value 0 -o part.vtp\n"
    "  arris contour ct.nrrd --value 320 -o part.stl --picture part.png");
  return { command, [options] { RunContour(*options); } };
}
}
