// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NrrdCheck.h"

#include <fstream>

namespace arris
{
std::string ProblemWithNrrd(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line))
  {
    if (file.eof()) // a last line without an end is none to vtkNrrdReader
    {
      break;
    }
    if (line.find_first_not_of(" \t\r") == std::string::npos)
    {
      return {};
    }
  }
  return "its header does not end with an empty line";
}
}
