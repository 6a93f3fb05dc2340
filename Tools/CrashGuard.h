// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file CrashGuard.h
/// A file that crashes its reader ends the program as any other file that cannot be read.

#ifndef arris_CrashGuard_h
#define arris_CrashGuard_h

#include <csignal>
#include <string>

namespace arris
{
/// VTK's readers trust their files, and some damaged ones make them write where they should not.
/// While this lives, a crash ends the program with this one line and exit status 1, and the
/// standard error is closed to the C libraries that readers use. Nothing is lost by ending so:
/// files are written when all has been read.
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
