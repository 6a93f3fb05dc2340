// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RecoveryOptions.h"

#include "Text.h"
#include "Validators.h"

#include "Support/Parameters.h"

#include <CLI/CLI.hpp>

namespace arris
{
namespace
{
constexpr const char* WindowOption = "--window";
constexpr const char* WindowRatioOption = "--window-ratio";
constexpr const char* SharpAngleOption = "--sharp-angle";
constexpr const char* WindowSearchOption = "--window-search";

/// An option that may be given many times, a position each.
CLI::Option* AddPositionOption(CLI::App& command, const std::string& name,
  std::vector<Position>& positions, const std::string& description, const std::string& group)
{
  return command
    .add_option_function<std::vector<std::string>>(
      name,
      [&positions](const std::vector<std::string>& texts)
      {
        for (const std::string& text : texts)
        {
          positions.push_back(*ParsePosition(text));
        }
      },
      description)
    ->check(PositionText())
    ->type_size(1)
    ->allow_extra_args(false)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
    ->type_name("X,Y,Z")
    ->group(group);
}

void AddWindowOptions(CLI::App& command, ClassificationOptions& options, const std::string& group,
  const std::string& ratioHelp, const std::string& angleHelp)
{
  CLI::Option* window = command
                          .add_option(WindowOption, options.Window,
                            "Window radius lambda, in the mesh's unit of length")
                          ->check(Positive())
                          ->type_name("LENGTH")
                          ->group(group);
  CLI::Option* ratio = command.add_option(WindowRatioOption, options.WindowRatio, ratioHelp)
                         ->check(Positive())
                         ->type_name("R")
                         ->excludes(window)
                         ->group(group);
  command.add_option(SharpAngleOption, options.SharpAngle, angleHelp)
    ->check(Angle())
    ->type_name("DEGREES")
    ->group(group);
  command
    .add_option(WindowSearchOption, options.WindowSearch,
      "connected (default): a window holds what is connected in\nit; spatial: all that is near")
    ->check(OneOf({ "connected", "spatial" }))
    ->type_name("connected|spatial")
    ->group(group);
  AddPositionOption(command, "--sharp-at", options.SharpAt,
    "A point that is expected to be sharp; the window and the\nangle follow. May be repeated",
    group)
    ->excludes(window)
    ->excludes(ratio);
  AddPositionOption(command, "--smooth-at", options.SmoothAt,
    "A point that is expected to be smooth. May be repeated", group);
  command
    .add_option("--patches", options.Patches,
      "The cell array that tells the patches of an assembly\n(default: PatchId, then "
      "BoundaryLabels; "
      "\"\": none)")
    ->type_name("ARRAY")
    ->group(group);
}
}

void AddClassificationOptions(CLI::App& command, ClassificationOptions& options)
{
  AddWindowOptions(command, options, "Method",
    "Window radius as a multiple of the average edge length\n(default " +
      Number(DefaultWindowRatio) + "; 0.5 to 1.5 are sensible)",
    "Vertices are sharp where the normals in their window\ndeviate by this (default " +
      Number(DefaultSharpAngle) + ")");
}

void AddRecoveryOptions(CLI::App& command, RecoveryOptions& options)
{
  command
    .add_option("--method", options.Method,
      "robust (default): needs no parameters; paper: step by\nstep as published")
    ->check(OneOf({ "paper", "robust" }))
    ->type_name("paper|robust")
    ->group("Method");
  AddWindowOptions(command, options, "Method",
    "Window radius as a multiple of the average edge length\n(default: " +
      Number(DefaultWindowRatio) + "; robust: of the local edge length)",
    "Edges are sharp from this turn on (default: robust\nchooses; paper " +
      Number(DefaultSharpAngle) + ", of the normals in a window)");
  command
    .add_flag("--denoise", options.Denoise,
      "Smooth faces of rough meshes (noise, segmentations) are\nmoved as well, not only their "
      "edges")
    ->group("Method");
  command
    .add_flag("--allow-flips", options.AllowFlips,
      "Edges inside the sharp region may be flipped where\ntriangles have no room otherwise")
    ->group("Method");
  command.callback(
    [&command, &options]
    {
      const bool paper = options.Method == "paper";
      if (!paper && command.count(WindowSearchOption) > 0)
      {
        throw CLI::ValidationError(WindowSearchOption, "applies to --method paper only");
      }
      if (paper && options.Denoise)
      {
        throw CLI::ValidationError("--denoise", "applies to --method robust only");
      }
      if (paper && options.AllowFlips)
      {
        throw CLI::ValidationError("--allow-flips", "applies to --method robust only");
      }
    });
}
}
