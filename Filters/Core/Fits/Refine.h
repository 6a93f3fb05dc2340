// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Refine.h
/// Brings a shape as near to a face as it goes.

#ifndef arris_Fits_Refine_h
#define arris_Fits_Refine_h

#include "FirstGuess.h"

namespace arris
{
/// Changes the parameters of a shape until the sum of its squared distances from the corners of the
/// triangles, by area, falls no further (Levenberg and Marquardt). `size` is that of the face.
ARRISFILTERS_EXPORT void Refine(const FaceSample& face, double size, Primitive& shape);
}

#endif
