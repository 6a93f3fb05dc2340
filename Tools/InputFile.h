// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file InputFile.h
/// What all files that are read have in common.

#ifndef arris_InputFile_h
#define arris_InputFile_h

#include <string>

class vtkAlgorithm;

namespace arris
{
class Failure;
class ProgressBar;

/// The part of the name from the last dot on, in lower case: ".ply".
std::string Extension(const std::string& path);

/// Throws a Failure unless there is a file that can be opened and is not empty.
void CheckReadable(const std::string& path);

/// What a file is in which that was found wrong.
Failure Unreadable(const std::string& path, const std::string& cause);

/// Runs a reader that has its file name; throws a Failure that says what the reader found wrong.
void RunReader(const std::string& path, vtkAlgorithm* reader, ProgressBar& progress);
}

#endif
