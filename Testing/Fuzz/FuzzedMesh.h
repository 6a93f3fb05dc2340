// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FuzzedMesh.h
/// Meshes of every kind that a filter may be given.

#ifndef arris_testing_FuzzedMesh_h
#define arris_testing_FuzzedMesh_h

#include "Decisions.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace arris
{
namespace testing
{
/// One of some sound meshes (contours of solids, a sheet, a fan, a row of single triangles, nothing
/// at all), then damaged: points moved to each other or to where no number is, cells turned over,
/// doubled, taken out or renamed, also to points that are not there, polygons, strips and lines
/// added, arrays of any size and kind.
vtkSmartPointer<vtkPolyData> FuzzedMesh(Decisions& decisions);
}
}

#endif
