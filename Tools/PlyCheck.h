// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PlyCheck.h
/// Whether a PLY file holds all that its header promises.

#ifndef arris_PlyCheck_h
#define arris_PlyCheck_h

#include <string>

namespace arris
{
/// What is wrong with a PLY file, or nothing. To be asked before vtkPLYReader, which crashes on a
/// file that ends too early.
std::string ProblemWithPly(const std::string& path);
}

#endif
