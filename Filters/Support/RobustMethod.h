// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file RobustMethod.h
/// The robust method on a surface, with its arrays.

#ifndef arris_RobustMethod_h
#define arris_RobustMethod_h

#include "Core/Parallel.h"
#include "Support/Surface.h"

class vtkPolyData;

namespace arris
{
/// Recovers the sharp edges of `surface` in `output`, which ReadSurface filled, and adds its
/// arrays. False if the monitor stopped it; the output is then unfinished.
bool RecoverByRobust(const Surface& surface, const Monitor& monitor, vtkPolyData* output);
}

#endif
