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
struct ClassifyOptions
{
  std::string Input;
  std::string Output;
  ClassificationOptions Classification;
  SessionOptions Common;
};

void RunClassify(const ClassifyOptions& options)
{
  CheckMeshOutput(options.Output, Content::MeshWithArrays);
  Session session("classify", options.Common);
  session.Report["input"] = options.Input;
  session.Report["output"] = options.Output;

  vtkSmartPointer<vtkPolyData> mesh;
  {
    const auto timer = session.Time("read");
    mesh = ReadMesh(options.Input, session.Progress);
  }
  mesh = Classify(session, mesh, options.Input, options.Classification);
  {
    const auto timer = session.Time("write");
    WriteMesh(mesh, options.Output, session.Progress);
  }
  session.Say("wrote " + options.Output);
  session.WriteReport();
}
}

Command AddClassify(CLI::App& program)
{
  const auto options = std::make_shared<ClassifyOptions>();
  CLI::App* command = program.add_subcommand(
    "classify", "Find the sharp region of a mesh: arrays USSOD, NormalDeviation, SharpRegion");
  AddInput(*command, options->Input, MeshInput);
  AddOutput(*command, options->Output, "Where to: .vtp or .vtk, which hold arrays");
  AddClassificationOptions(*command, options->Classification);
  AddSessionOptions(*command, options->Common);
  command->footer("Example:\n"
                  "  arris classify scan.ply -o classified.vtp --sharp-angle 35");
  return { command, [options] { RunClassify(*options); } };
}
}
