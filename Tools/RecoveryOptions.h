// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file RecoveryOptions.h
/// The parameters of the method on the command line.

#ifndef arris_RecoveryOptions_h
#define arris_RecoveryOptions_h

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace arris
{
/// A position given as x,y,z.
using Position = std::array<double, 3>;

/// What is not given is left to the filters.
struct ClassificationOptions
{
  std::optional<double> Window;
  std::optional<double> WindowRatio;
  std::optional<double> SharpAngle;
  std::string WindowSearch = "connected"; ///< or "spatial"
  std::vector<Position> SharpAt; ///< picked points
  std::vector<Position> SmoothAt;
  std::optional<std::string> Patches; ///< the cell array that tells the patches of an assembly
};

struct RecoveryOptions : ClassificationOptions
{
  std::string Method = "robust"; ///< or "paper"
  bool Denoise = false;
  bool AllowFlips = false;
};

/// --window, --window-ratio, --sharp-angle, --window-search, --sharp-at, --smooth-at, --patches.
void AddClassificationOptions(CLI::App& command, ClassificationOptions& options);

/// These, --method and --denoise.
void AddRecoveryOptions(CLI::App& command, RecoveryOptions& options);
}

#endif
