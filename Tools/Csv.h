// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Csv.h
/// Tables as comma-separated values.

#ifndef arris_Csv_h
#define arris_Csv_h

#include <string>

class vtkTable;

namespace arris
{
/// Writes a line with the names of the columns and one for each row, numbers with all their digits
/// (vtkDelimitedTextWriter writes six). A column of several components becomes several: "Axis:0",
/// "Axis:1". Throws a Failure if it cannot, and then leaves what is there.
void WriteCsv(vtkTable* table, const std::string& path);
}

#endif
