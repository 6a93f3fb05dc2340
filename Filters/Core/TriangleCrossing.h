// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file TriangleCrossing.h
/// Whether two triangles of a mesh cut through each other.

#ifndef arris_TriangleCrossing_h
#define arris_TriangleCrossing_h

#include "Mesh.h"

namespace arris
{
/// True if the two triangles cut through each other as FindIntersections understands it.
bool CutThrough(const MeshView& mesh, Index t1, Index t2);
}

#endif
