// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Selections.h
/// What a vtkSelection selects of a mesh. VTK's own evaluation is in a module that depends on MPI
/// where VTK was built with it; this needs none.

#ifndef arris_Selections_h
#define arris_Selections_h

#include <vtkType.h>

#include <string>
#include <vector>

class vtkPolyData;
class vtkSelection;

namespace arris
{
struct SelectedElements
{
  bool AreCells = false; ///< or points
  std::vector<vtkIdType> Ids; ///< ascending
};

/// Evaluates the nodes of a selection, inverted ones and expressions included. Nodes may list
/// indices, global or pedigree ids, values, thresholds, locations (the nearest point or cell) or
/// frusta (a cell is in one if a point of it is). What cannot be evaluated, or nothing.
std::string EvaluateSelection(
  vtkSelection* selection, vtkPolyData* mesh, SelectedElements& selected);
}

#endif
