// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Welding.h
/// Makes the parts of an assembly share the vertices and triangles that they have in common.

#ifndef arris_Assembly_Welding_h
#define arris_Assembly_Welding_h

#include "Core/Mesh.h"

namespace arris
{
/// For each vertex the lowest of those that it is one with, mostly itself. Vertices no farther than
/// `tolerance` apart are one if one of them is on an open edge or if they belong to triangles of
/// different ids: what touches itself without that, as the contours of some volumes do, stays as it
/// is. So do the ends of an edge that is shorter than that. `ids` has one entry a triangle, or none
/// at all.
std::vector<Index> WeldedVertices(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Index>& ids, double tolerance);

/// Names welded vertices in the triangles. Triangles that lose an edge that way are none any more;
/// of several on the same three vertices only the first stays, and the set of their ids is its new
/// id (where two closed parts touch, their common face is there twice). `kept` tells which of the
/// triangles are left, ascending.
void WeldTriangles(
  const std::vector<Index>& welded, Mesh& mesh, std::vector<Index>& ids, std::vector<Index>& kept);
}

#endif
