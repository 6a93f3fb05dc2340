// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file StlCheck.h
/// Whether an STL file holds all that it promises.

#ifndef arris_StlCheck_h
#define arris_StlCheck_h

#include <string>

namespace arris
{
/// What is wrong with an STL file, or nothing. vtkSTLReader takes one that ends too early for a
/// shorter one.
std::string ProblemWithStl(const std::string& path);
}

#endif
