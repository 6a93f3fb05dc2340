// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PaperMethod.h
/// The method of the paper from end to end: classify, thin, sharpen.

#ifndef arris_PaperMethod_h
#define arris_PaperMethod_h

#include "Support/Classification.h"

class vtkPolyData;

namespace arris
{
/// Recovers the sharp edges of `surface` in `output`, which ReadSurface filled from `input`, and
/// adds the arrays of all stages. `classification` may know the mesh from an earlier run. False if
/// the monitor stopped it; the output is then unfinished. Move the surface in: it is used up stage
/// by stage, to save memory.
bool RecoverByPaper(vtkPolyData* input, Surface surface, const ClassificationParameters& parameters,
  Classification& classification, const Monitor& monitor, vtkPolyData* output);
}

#endif
