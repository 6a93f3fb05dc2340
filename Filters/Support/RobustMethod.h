// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file RobustMethod.h
/// The robust method on a surface, with its arrays.

#ifndef arris_RobustMethod_h
#define arris_RobustMethod_h

#include "Core/Robust/Robust.h"
#include "Support/Surface.h"

class vtkPolyData;

namespace arris
{
/// Recovers the sharp edges of `surface` in `output`, which ReadSurface filled from `input`, and
/// adds its arrays. False if the monitor stopped it; the output is then unfinished.
bool RecoverByRobust(vtkPolyData* input, const Surface& surface, const RobustParameters& parameters,
  const Monitor& monitor, vtkPolyData* output);

/// Whether the method found the mesh rough and worked on a smoothed copy.
bool IsRough(vtkPolyData* recovered);

/// Whether the method found the mesh's bends meant and left them as they are.
bool AreBendsMeant(vtkPolyData* recovered);
}

#endif
