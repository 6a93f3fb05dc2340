// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file DataFolder.h
/// Where the real input of the demo is.

#ifndef arris_DataFolder_h
#define arris_DataFolder_h

#include <string>

namespace arris
{
/// The folder with bracket.mha: the given one; else the environment's ARRIS_DATA; else share/arris
/// of the installation this program is in; else Data of the sources it was built from. Throws a
/// Failure if it is not there.
std::string DataFolder(const std::string& given);
}

#endif
