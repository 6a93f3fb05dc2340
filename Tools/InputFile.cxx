// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InputFile.h"

#include "CrashGuard.h"
#include "ErrorCapture.h"
#include "Failure.h"
#include "ProgressBar.h"

#include <vtkAlgorithm.h>
#include <vtkDataReader.h>
#include <vtkImageReader2.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace arris
{
std::string Extension(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& letter : extension)
  {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return extension;
}

void CheckReadable(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
  {
    throw Failure(path, "cannot be read: no such file", "check its name and folder");
  }
  if (!fs::is_regular_file(status))
  {
    throw Failure(path, "cannot be read: it is not a regular file", "give the name of a file");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw Failure(
      path, std::string("cannot be read: ") + std::strerror(errno), "check its permissions");
  }
  if (file.peek() == std::ifstream::traits_type::eof())
  {
    throw Failure(path, "cannot be read: the file is empty", "write or copy it again");
  }
}

Failure Unreadable(const std::string& path, const std::string& cause)
{
  return Failure(path, "cannot be read: " + cause,
    "check that it is complete and what its extension says it is");
}

void RunReader(const std::string& path, vtkAlgorithm* reader, ProgressBar& progress)
{
  const ErrorCapture capture;
  progress.Follow("reading", reader);
  {
    const CrashGuard guard(
      std::string("arris: ") + Unreadable(path, "it is damaged").what() + "\n");
    reader->Update();
  }
  progress.Clear();
  // These only warn, or write to the standard error, where a file ends too early.
  const bool onlyWarns = vtkDataReader::SafeDownCast(reader) != nullptr ||
    vtkImageReader2::SafeDownCast(reader) != nullptr;
  const std::string cause = onlyWarns ? capture.FirstWord() : capture.FirstError();
  if (!cause.empty())
  {
    throw Unreadable(path, cause);
  }
  if (reader->GetErrorCode() != 0)
  {
    throw Unreadable(path, "it is damaged or incomplete");
  }
}
}
