// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file StopWatch.h
/// Seconds since it was made.

#ifndef arris_StopWatch_h
#define arris_StopWatch_h

#include <chrono>

namespace arris
{
class StopWatch
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - this->Start).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Start = Clock::now();
};
}

#endif
