// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PatchIds.h
/// Which patch of an assembly the cells of a vtkPolyData say that they belong to.

#ifndef arris_PatchIds_h
#define arris_PatchIds_h

#include "Surface.h"

#include <string>

namespace arris
{
/// The array that is read if no other is asked for, and the one that is read if there is none such:
/// two numbers a cell for the materials on its two sides, as vtkSurfaceNets3D gives them.
constexpr const char* DefaultPatchArray = "PatchId";
constexpr const char* BoundaryLabelsArray = "BoundaryLabels";

/// Reads the cell array `name`: one whole number a cell, or two in any order. Cells of the same
/// numbers get the same id, counted from 0; those with a negative or no number where there should
/// be one patch number have one of their own. Leaves `ids` empty if there is no array, which is
/// wrong only for another name than the default; an empty name reads none. What is wrong with
/// the array, or nothing.
std::string ReadPatchIds(
  vtkPolyData* mesh, const std::string& name, const Surface& surface, std::vector<Index>& ids);
}

#endif
