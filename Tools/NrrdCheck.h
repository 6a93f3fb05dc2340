// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file NrrdCheck.h
/// Whether the header of a NRRD file ends.

#ifndef arris_NrrdCheck_h
#define arris_NrrdCheck_h

#include <string>

namespace arris
{
/// What is wrong with the header of a NRRD file, or nothing. To be asked before vtkNrrdReader,
/// which looks for the empty line at its end for ever.
std::string ProblemWithNrrd(const std::string& path);
}

#endif
