// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file CrashGuard.h
/// A crash in a library ends the program as any other failure does.

#ifndef arris_CrashGuard_h
#define arris_CrashGuard_h

#include <csignal>
#include <string>

namespace arris
{
/// VTK's readers trust their files, and some damaged ones make them write where they should not;
/// and VTK ends the process when its X display is lost. While this lives, a crash ends the program
/// with one line and exit status 1, and the standard error is closed to the C libraries below VTK.
/// Nothing is lost by ending so: other files are written after all has been read, and before the
/// first picture is drawn.
class CrashGuard
{
public:
  explicit CrashGuard(const std::string& lastWords);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  void operator=(const CrashGuard&) = delete;

private:
  static constexpr int Signals[] = { SIGSEGV, SIGABRT, SIGBUS, SIGFPE };
  struct sigaction Previous[4];
};
}

#endif
