// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FaceFit.h
/// Which shape a face of the mesh has.

#ifndef arris_Fits_FaceFit_h
#define arris_Fits_FaceFit_h

#include "Core/Mesh.h"
#include "Core/Parallel.h"
#include "Primitive.h"

namespace arris
{
struct FaceFit
{
  Primitive Shape; ///< FreeForm if none fits
  double Residual = 0.0; ///< RMS distance of the face's vertices, by area; of the best shape if
                         ///< none fits
};

/// For each surface the simplest shape that fits it: whose RMS distance is within `tolerance` mean
/// edge lengths of the face, whose normals agree with the triangles' within 10 degrees (RMS), and
/// than which no other shape is twice as near. `surfaceIds` numbers the surface of each triangle
/// from 0 to `surfaceCount` - 1. Empty if the monitor stopped it.
ARRISFILTERS_EXPORT std::vector<FaceFit> FitFaces(const Mesh& mesh,
  const std::vector<Index>& surfaceIds, Index surfaceCount, double tolerance,
  const Monitor& monitor);
}

#endif
