// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Labelling.h
/// The damaged vertices, the sides of each, and which of them each lies on.

#ifndef arris_Robust_Labelling_h
#define arris_Robust_Labelling_h

#include "Apexes.h"
#include "Core/Parallel.h"
#include "Labels.h"

namespace arris
{
/// All that has been found out about the damaged vertices.
struct Labelling
{
  std::vector<Index> Labels; ///< for each vertex its patch
  std::vector<std::vector<Side>> Sides; ///< of the vertices of the region, in their order
  std::vector<Index> SidesOf; ///< for each vertex where in Sides; NoIndex if intact

  std::vector<LocalSolid> Solids; ///< that the sides bound
  std::vector<Index> SolidOf; ///< for each row of Sides which of Solids

  /// Labels from here on are those of tips: no edge runs around one.
  Index FirstApexLabel = 0;

  /// The sheet of a label as a vertex sees it, or one of its neighbours does; null if none.
  const Sheet* SheetAt(const Connectivity& connectivity, Index vertex, Index label) const;

  /// Of a damaged vertex, the side that it lies on and the solid that its sides bound; null if
  /// none.
  const Side* SideAt(Index vertex) const;
  const LocalSolid* SolidAt(Index vertex) const;
};

/// Gives the vertices of each tip one label of its own and no sides, so that no ridge runs around
/// it.
ARRISFILTERS_EXPORT void LabelTips(const std::vector<Apex>& apexes, Labelling& labelling);

/// Fits the sides of every vertex of the region, but for those that are `unfitted` (empty if none
/// are), sorts what is intact into patches, gives narrow faces back to the intact part (which
/// shrinks the region), and labels the rest, tips included. False if the monitor stopped it.
bool LabelVertices(const Surroundings& around, const std::vector<Apex>& apexes,
  const Flags& unfitted, const Monitor& monitor, Flags& region, Labelling& labelling);
}

#endif
