// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file RecoveryOptions.h
/// The parameters of the method on the command line.

#ifndef arris_RecoveryOptions_h
#define arris_RecoveryOptions_h

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace arris
{
/// What is not given is left to the filters.
struct ClassificationOptions
{
  std::optional<double> Window;
  std::optional<double> WindowRatio;
  std::optional<double> SharpAngle;
  std::string WindowSearch = "connected"; ///< or "spatial"
};

struct RecoveryOptions : ClassificationOptions
{
  std::string Method = "robust"; ///< or "paper"
  bool Denoise = false;
};

/// --window, --window-ratio, --sharp-angle, --window-search.
void AddClassificationOptions(CLI::App& command, ClassificationOptions& options);

/// These, --method and --denoise.
void AddRecoveryOptions(CLI::App& command, RecoveryOptions& options);
}

#endif
