// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ReplaceTriangles.h
/// Hands on a mesh whose edges were flipped.

#ifndef arris_ReplaceTriangles_h
#define arris_ReplaceTriangles_h

#include "Surface.h"

namespace arris
{
/// Gives those cells of the output other corners whose triangles are not those of the surface any
/// more. Each keeps its number, and so its data, and is wound as it was. No triangles leave all as
/// it is.
void ReplaceTriangles(
  vtkPolyData* output, const Surface& surface, const std::vector<Triangle>& triangles);
}

#endif
