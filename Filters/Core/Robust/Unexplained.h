// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Unexplained.h
/// Faces so narrow that the region has swallowed them show in vertices that no side passes near.

#ifndef arris_Robust_Unexplained_h
#define arris_Robust_Unexplained_h

#include "Labelling.h"

namespace arris
{
/// Takes groups of damaged vertices that lie off all their sides out of the region, and returns
/// them: they are on a face that nothing intact speaks for.
std::vector<Index> ReleaseUnexplained(const Surroundings& around, const std::vector<Index>& damaged,
  const Labelling& labelling, Flags& region);

/// The vertices of the region to whose sides the released ones may have added.
std::vector<Index> DamagedNear(
  const Surroundings& around, const std::vector<Index>& released, const Flags& region);
}

#endif
