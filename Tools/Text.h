// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Text.h
/// Numbers as the program prints them.

#ifndef arris_Text_h
#define arris_Text_h

#include <vtkType.h>

#include <cstdio>
#include <string>

namespace arris
{
/// With so many significant digits.
inline std::string Number(double value, int digits = 4)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*g", digits, value);
  return text;
}

/// "1 curve", "2 curves".
inline std::string Count(vtkIdType count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}
}

#endif
