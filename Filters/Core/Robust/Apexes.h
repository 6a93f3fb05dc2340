// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Apexes.h
/// Tips: small sharp regions by themselves, around which all tangent planes meet in one point.

#ifndef arris_Robust_Apexes_h
#define arris_Robust_Apexes_h

#include "Sides.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
struct Apex
{
  Index Vertex; ///< the one nearest to the tip, which goes there
  Vec3 Tip;
  std::vector<Index> Members; ///< the vertices around, with this one
  std::vector<Vec3> Places; ///< of these; without a blur all but the tip stay where they are
};

ARRISFILTERS_EXPORT std::vector<Apex> FindApexes(const Surroundings& around, const Flags& region);
}

#endif
