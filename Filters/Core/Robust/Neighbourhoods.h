// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Neighbourhoods.h
/// Damaged vertices near each other see the same faces: they share what is fitted to these.

#ifndef arris_Robust_Neighbourhoods_h
#define arris_Robust_Neighbourhoods_h

#include "Core/Mesh.h"

namespace arris
{
struct Surroundings;

/// Groups of connected damaged vertices, each with its centre first. The sharpest vertices are the
/// centres, so that the groups follow the edge and not the order of storage.
Rows GroupIntoNeighbourhoods(const Surroundings& around, const std::vector<Index>& damaged);
}

#endif
