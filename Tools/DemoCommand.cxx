// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Commands.h"

#include "AtomicFile.h"
#include "ComparisonReport.h"
#include "Contour.h"
#include "CurveCoverage.h"
#include "DataFolder.h"
#include "Failure.h"
#include "FeatureStage.h"
#include "InOut.h"
#include "MeshFiles.h"
#include "Picture.h"
#include "Session.h"
#include "Stages.h"
#include "Text.h"
#include "VolumeFiles.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <filesystem>

namespace arris
{
namespace
{
namespace fs = std::filesystem;

/// Two edges are the same when they are this near, in cells of the volume.
constexpr double EdgeTolerance = 0.1;

/// Edges that turn by less, in degrees, are not counted. The bracket's shallowest turns by 45.
constexpr double ShallowestEdge = 20.0;

/// The front of the bearing housing, with the port on top of it.
View CloseUp()
{
  View view;
  view.Middle = { 0.5, 0.75 };
  view.Extent = 0.35;
  return view;
}

struct DemoOptions
{
  std::string Folder = "arris-demo";
  std::string Data;
  RecoveryOptions Recovery;
  FeatureOptions Features;
  SessionOptions Common;

  DemoOptions() { this->Features.FeatureAngle = ShallowestEdge; }
};

/// What is known of the part: its surface and its sharp edges.
struct Truth
{
  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkPolyData> Edges;
};

/// How well a mesh and its feature curves fit the truth.
struct Score
{
  Comparison Distance;
  double Recall;
  double Precision;
};

Score Judge(
  Session& session, vtkPolyData* mesh, vtkPolyData* curves, const Truth& truth, double tolerance)
{
  const auto timer = session.Time("compare");
  constexpr vtkIdType Samples = 200000;
  session.Progress.Start("comparing");
  Score score;
  score.Distance = Compare(
    truth.Surface, mesh, Samples, [&](double fraction) { session.Progress.Show(fraction); });
  session.Progress.Clear();
  score.Recall = CurveCoverage(truth.Edges, curves, tolerance);
  score.Precision = CurveCoverage(curves, truth.Edges, tolerance);
  return score;
}

Session::Json ToJson(const Score& score)
{
  Session::Json json = ToJson(score.Distance);
  json["edge_recall"] = score.Recall;
  json["edge_precision"] = score.Precision;
  return json;
}

void SayScore(const Session& session, const char* when, const Score& score)
{
  session.Say(std::string("\n") + when);
  SayComparison(session, score.Distance);
  session.Say("true sharp edges found " + Number(100.0 * score.Recall, 3) +
    " %, found edges that are true " + Number(100.0 * score.Precision, 3) + " %");
}

/// The files of the demo, in the folder it writes to.
struct DemoFiles
{
  fs::path Folder;
  std::string operator()(const char* name) const { return (this->Folder / name).string(); }
};

DemoFiles MakeFolder(const std::string& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
  {
    throw Failure(folder,
      "cannot be made: " + (error ? error.message() : "a file of that name is there"),
      "choose another folder with -o");
  }
  DemoFiles files{ folder };
  CheckWritable(files("before.ply"));
  return files;
}

void DrawPictures(Session& session, const DemoFiles& out, vtkPolyData* before, vtkPolyData* after,
  const Features& features)
{
  const Scene sceneBefore{ "before", before };
  const Scene sceneAfter{ "after", after };
  Scene nearBefore{ "", before };
  Scene nearAfter{ "", after };
  nearBefore.Eye = CloseUp();
  nearAfter.Eye = CloseUp();
  DrawPicture(out("before.png"), { sceneBefore });
  DrawPicture(out("after.png"), { sceneAfter });
  DrawPicture(out("before-after.png"), { sceneBefore, sceneAfter, nearBefore, nearAfter }, 2);
  DrawPicture(out("edges.png"), { { "sharp edges", after, features.Curves, features.Corners } });
  session.Say("drew before.png, after.png, before-after.png and edges.png there");
}

void Demo(const DemoOptions& options)
{
  const DemoFiles in{ DataFolder(options.Data) };
  const DemoFiles out = MakeFolder(options.Folder);
  Session session("demo", options.Common, true);
  session.Report["input"] = in("bracket.mha");
  session.Report["output"] = options.Folder;

  vtkSmartPointer<vtkImageData> volume;
  Truth truth;
  {
    const auto timer = session.Time("read");
    volume = ReadVolume(in("bracket.mha"), session.Progress);
    truth.Surface = ReadMesh(in("bracket.ply"), session.Progress);
    truth.Edges = ReadCurves(in("bracket-edges.vtp"), session.Progress);
  }
  vtkSmartPointer<vtkPolyData> before;
  {
    const auto timer = session.Time("contour");
    before = Contour(volume, 0.0, Inside::Auto, in("bracket.mha"), session.Progress);
  }
  const auto after = Recover(session, before, in("bracket.mha"), options.Recovery);
  const Features chamfers = FindFeatures(session, before, "before.vtp", options.Features);
  const Features features = FindFeatures(session, after, "after.vtp", options.Features);
  ReportFeatures(session, features);
  {
    const auto timer = session.Time("write");
    WriteMesh(before, out("before.ply"), session.Progress);
    WriteMesh(before, out("before.vtp"), session.Progress);
    WriteMesh(after, out("after.ply"), session.Progress);
    WriteMesh(after, out("after.vtp"), session.Progress);
    WriteMesh(features.Curves, out("edges.vtp"), session.Progress);
    WriteMesh(features.Corners, out("corners.vtp"), session.Progress);
  }
  const double tolerance = EdgeTolerance * volume->GetSpacing()[0];
  const Score scoreBefore = Judge(session, before, chamfers.Curves, truth, tolerance);
  const Score scoreAfter = Judge(session, after, features.Curves, truth, tolerance);
  session.Report["edge_tolerance"] = tolerance;
  session.Report["before"] = ToJson(scoreBefore);
  session.Report["after"] = ToJson(scoreAfter);
  SayScore(session, "before", scoreBefore);
  SayScore(session, "after", scoreAfter);
  session.Say("\nwrote before, after (.ply, .vtp), edges.vtp and corners.vtp to " + options.Folder);
  session.WriteReport();
  session.Draw(
    out("before-after.png"), [&] { DrawPictures(session, out, before, after, features); });
}
}

Command AddDemo(CLI::App& program)
{
  const auto options = std::make_shared<DemoOptions>();
  CLI::App* command = program.add_subcommand("demo",
    "Recover a real part from its sampled volume, with pictures and distances to the truth");
  command->add_option("-o,--output", options->Folder, "Where to (default arris-demo)")
    ->type_name("FOLDER");
  command
    ->add_option("--data", options->Data,
      "The folder with bracket.mha, bracket.ply and\nbracket-edges.vtp (default: the environment's "
      "ARRIS_DATA,\nelse the one that came with the program)")
    ->type_name("FOLDER");
  AddRecoveryOptions(*command, options->Recovery);
  AddFeatureOptions(*command, options->Features);
  AddSessionOptions(*command, options->Common);
  command->footer("The pictures need an X display; without one all else is done, and the exit "
                  "status is 1.\n\n"
                  "Examples:\n"
                  "  arris demo\n"
                  "  xvfb-run -a arris demo -o /tmp/demo --method paper");
  return { command, [options] { Demo(*options); } };
}
}
