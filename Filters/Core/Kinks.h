// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Kinks.h
/// Turns of a curve that it takes back at once.

#ifndef arris_Kinks_h
#define arris_Kinks_h

#include "EdgeGraph.h"
#include "Mesh.h"

namespace arris
{
/// Clears the flags of turns (nodes of valence two) where a curve goes on beyond as it came: up to
/// three edges, with turns at both ends, between stretches of three edges that do not turn and
/// whose directions differ by no more than `angle` degrees. Where the curve ends at a junction
/// before that, the chord from there across the turns differs by half of that at most.
/// So a vertex that stands off a finely cut curve is no corner, and a coarse outline keeps all of
/// its corners: beside each is another.
void ForgetKinks(const EdgeGraph& graph, const std::vector<Vec3>& points, const Flags& junctions,
  double angle, Flags& turns);
}

#endif
