// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DataFolder.h"

#include "Failure.h"

#include <cstdlib>
#include <filesystem>

namespace arris
{
namespace
{
namespace fs = std::filesystem;

bool HoldsData(const fs::path& folder)
{
  std::error_code error;
  return fs::exists(folder / "bracket.mha", error);
}
}

std::string DataFolder(const std::string& given)
{
  const char* fromEnvironment = std::getenv("ARRIS_DATA");
  std::string chosen = !given.empty() || fromEnvironment == nullptr ? given : fromEnvironment;
  if (!chosen.empty())
  {
    if (!HoldsData(chosen))
    {
      throw Failure(chosen, "holds no bracket.mha",
        "give the folder Data of the sources with --data or in ARRIS_DATA");
    }
    return chosen;
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (const fs::path& folder :
    { program.parent_path().parent_path() / ARRIS_INSTALLED_DATA, fs::path(ARRIS_SOURCE_DATA) })
  {
    if (HoldsData(folder))
    {
      return folder.string();
    }
  }
  throw Failure("bracket.mha", "cannot be found",
    "give the folder Data of the sources with --data or in ARRIS_DATA");
}
}
