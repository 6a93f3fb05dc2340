// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PaperMethod.h
/// The method of the paper from end to end: classify, thin, sharpen.

#ifndef arris_PaperMethod_h
#define arris_PaperMethod_h

#include "Core/Parallel.h"
#include "Core/Ussod.h"
#include "Support/Surface.h"

class vtkPolyData;

namespace arris
{
struct PaperParameters
{
  double WindowRadius; ///< λ, in units of length
  double SharpAngle; ///< degrees
  WindowSearch Search;
};

/// Recovers the sharp edges of `surface` in `output`, which ReadSurface filled, and adds the arrays
/// of all stages. False if the monitor stopped it; the output is then unfinished.
bool RecoverByPaper(const Surface& surface, const PaperParameters& parameters,
  const Monitor& monitor, vtkPolyData* output);
}

#endif
