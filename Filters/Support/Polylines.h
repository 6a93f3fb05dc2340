// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Polylines.h
/// Curves on a mesh as polygonal data of their own.

#ifndef arris_Polylines_h
#define arris_Polylines_h

#include "Core/Curves.h"

class vtkPolyData;

namespace arris
{
/// Fills `lines` with one polyline a curve, on those points of `mesh` that the curves use, in the
/// mesh's order, with these points' arrays.
void FillPolylines(vtkPolyData* lines, const std::vector<Curve>& curves, vtkPolyData* mesh);
}

#endif
