// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Junctions.h
/// Assemblies: each patch is looked at apart, and their common vertices are placed together.

#ifndef arris_Robust_Junctions_h
#define arris_Robust_Junctions_h

#include "Core/Assembly/PatchesApart.h"
#include "Labelling.h"

namespace arris
{
/// Marks the parts of common vertices, and what is as near to them as sampling takes vertices off
/// their face beside an edge: where patches meet is an edge, whatever one of them shows of it.
void AddJunctions(const PatchesApart& apart, const std::vector<Vec3>& points,
  const std::vector<double>& scales, Flags& region);

/// Moves the parts of each common vertex to their mean.
void BringTogether(const PatchesApart& apart, std::size_t wholeCount, std::vector<Vec3>& points);

/// What was found out about the parts of each vertex of the whole, as one.
Labelling JoinParts(const PatchesApart& apart, std::size_t wholeCount, const Labelling& ofParts);

/// 1 for the vertices of the whole inside a curve between patches: with two of its edges, no more
/// and no less.
Flags InsideJunctions(const Mesh& whole, const Connectivity& connectivity);
}

#endif
