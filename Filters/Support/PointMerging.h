// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PointMerging.h
/// Sews a mesh together whose triangles do not share their points.

#ifndef arris_PointMerging_h
#define arris_PointMerging_h

#include "Surface.h"

namespace arris
{
/// Where the mesh has open edges, takes their points that are within `tolerance` (a part of the
/// bounding box' diagonal) of each other for one, the lowest of them. That changes which points the
/// triangles of `surface` name, not the vtkPolyData. A triangle that loses an edge that way is none
/// any more. Closed meshes cost nothing.
void MergeOpenPoints(double tolerance, Surface& surface);

/// Whether there are triangles, but no two that share an edge.
bool IsSoup(const Surface& surface);
}

#endif
