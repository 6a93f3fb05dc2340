// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ProgressBar.h
/// Shows on a terminal how far a stage has come.

#ifndef arris_ProgressBar_h
#define arris_ProgressBar_h

#include <chrono>
#include <cstdio>
#include <string>

class vtkAlgorithm;
class vtkObject;

namespace arris
{
/// One line on standard error that is drawn over, and gone at the end. Draws nothing unless it is
/// switched on and standard error is a terminal.
class ProgressBar
{
public:
  explicit ProgressBar(bool on);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  void operator=(const ProgressBar&) = delete;

  /// From here on the bar is that of another stage.
  void Start(const std::string& stage);

  /// From here on the bar follows this algorithm, which must outlive the next Start or Clear.
  void Follow(const std::string& stage, vtkAlgorithm* algorithm);

  /// How much of the stage is done, from 0 to 1.
  void Show(double fraction);

  /// Takes the bar off the screen.
  void Clear();

private:
  void OnProgress(vtkObject* caller, unsigned long event, void* data);
  void LetGo();

  using Clock = std::chrono::steady_clock;
  std::FILE* Terminal; ///< none if there is nothing to draw on
  std::string Stage;
  vtkAlgorithm* Followed = nullptr;
  unsigned long Observer = 0;
  Clock::time_point LastDrawn;
  bool Drawn = false;
};
}

#endif
