// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Retreat.h
/// The last guard: gives vertices back where the input had them until no triangle is folded over
/// and none cuts another that did not before.

#ifndef arris_Robust_Retreat_h
#define arris_Robust_Retreat_h

#include "Placement.h"

namespace arris
{
void Retreat(const Mesh& mesh, const Connectivity& connectivity, Placement& placement);
}

#endif
