// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ProgressBar.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace arris
{
ProgressBar::ProgressBar(bool on)
  : Terminal(on && isatty(STDERR_FILENO) != 0 ? fdopen(dup(STDERR_FILENO), "w") : nullptr)
{
}

ProgressBar::~ProgressBar()
{
  this->Clear();
  if (this->Terminal != nullptr)
  {
    std::fclose(this->Terminal);
  }
}

void ProgressBar::Start(const std::string& stage)
{
  this->LetGo();
  this->Stage = stage;
  this->LastDrawn = Clock::time_point(); // long ago: the first word is drawn at once
  this->Show(0.0);
}

void ProgressBar::Follow(const std::string& stage, vtkAlgorithm* algorithm)
{
  this->Start(stage);
  if (this->Terminal != nullptr)
  {
    this->Followed = algorithm;
    this->Observer =
      algorithm->AddObserver(vtkCommand::ProgressEvent, this, &ProgressBar::OnProgress);
  }
}

void ProgressBar::Show(double fraction)
{
  constexpr auto Pause = std::chrono::milliseconds(40);
  const Clock::time_point now = Clock::now();
  if (this->Terminal == nullptr || now - this->LastDrawn < Pause)
  {
    return;
  }
  this->LastDrawn = now;
  this->Drawn = true;
  constexpr int Width = 30;
  const double part = std::clamp(fraction, 0.0, 1.0);
  const std::string done(static_cast<std::size_t>(part * Width), '#');
  std::fprintf(this->Terminal, "\r%-12s [%-*s] %3.0f %%", this->Stage.c_str(), Width, done.c_str(),
    100.0 * part);
  std::fflush(this->Terminal);
}

void ProgressBar::Clear()
{
  this->LetGo();
  if (this->Drawn)
  {
    std::fputs("\r\033[K", this->Terminal);
    std::fflush(this->Terminal);
    this->Drawn = false;
  }
}

void ProgressBar::OnProgress(vtkObject*, unsigned long, void* data)
{
  this->Show(*static_cast<double*>(data));
}

void ProgressBar::LetGo()
{
  if (this->Followed != nullptr)
  {
    this->Followed->RemoveObserver(this->Observer);
    this->Followed = nullptr;
  }
}
}
