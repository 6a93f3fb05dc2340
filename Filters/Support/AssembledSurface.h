// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file AssembledSurface.h
/// A surface that was read as an assembly of patches, and its results back to all its points.

#ifndef arris_AssembledSurface_h
#define arris_AssembledSurface_h

#include "Surface.h"

namespace arris
{
/// Makes an assembly of a surface that ReadSurface has read (see MakeAssembly). What is wrong with
/// the patch ids, or nothing.
std::string AssembleSurface(
  vtkPolyData* output, const AssemblyParameters& parameters, Surface& surface);

/// Gives every point the position of the one that it is one with.
void ShareAmongCommon(const Surface& surface, std::vector<Vec3>& points);

/// The same for the arrays that the filters of Arris have added to points.
void ShareAmongCommon(const Surface& surface, vtkPolyData* output);
}

#endif
