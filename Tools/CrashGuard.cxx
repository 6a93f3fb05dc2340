// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CrashGuard.h"

#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <unistd.h>

namespace arris
{
namespace
{
// A signal handler can reach nothing else.
std::string LastWords;
int StandardError = -1;

void End(int)
{
  constexpr int Failed = 1;
  if (write(StandardError, LastWords.data(), LastWords.size()) < 0)
  {
    _exit(Failed); // there is nobody to tell
  }
  _exit(Failed);
}
}

CrashGuard::CrashGuard(const std::string& lastWords)
{
  LastWords = lastWords;
  std::fflush(stderr);
  StandardError = dup(STDERR_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
  struct sigaction action;
  std::memset(&action, 0, sizeof(action));
  action.sa_handler = End;
  for (std::size_t i = 0; i < std::size(Signals); ++i)
  {
    sigaction(Signals[i], &action, &this->Previous[i]);
  }
}

CrashGuard::~CrashGuard()
{
  for (std::size_t i = 0; i < std::size(Signals); ++i)
  {
    sigaction(Signals[i], &this->Previous[i], nullptr);
  }
  std::fflush(stderr);
  dup2(StandardError, STDERR_FILENO);
  close(StandardError);
}
}
