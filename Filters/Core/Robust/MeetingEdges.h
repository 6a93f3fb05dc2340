// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file MeetingEdges.h
/// Completes the sharp region where edges meet.

#ifndef arris_Robust_MeetingEdges_h
#define arris_Robust_MeetingEdges_h

#include "Region.h"

namespace arris
{
/// Adds what a turn could not show where edges meet: there, one side of a vertex is another edge,
/// and a shallow edge would end before it reaches a strong one. The turn is taken again without
/// the triangles of the region.
void ExtendToOtherEdges(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& scales, const std::vector<Turn>& turns, const EdgeAngles& angles,
  bool rounded, Flags& region);
}

#endif
