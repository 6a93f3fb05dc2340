// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Failure.h
/// What stops a command, in words for the user.

#ifndef arris_Failure_h
#define arris_Failure_h

#include <stdexcept>
#include <string>

namespace arris
{
/// One line that names the file, the cause and what to do. The program prints it and ends with
/// status 1.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;

  Failure(const std::string& file, const std::string& cause, const std::string& advice)
    : std::runtime_error(file + ": " + cause + "; " + advice)
  {
  }
};
}

#endif
