// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Denoised.h
/// A smooth copy of a rough mesh, edges and all.

#ifndef arris_Robust_Denoised_h
#define arris_Robust_Denoised_h

#include "Core/Parallel.h"
#include "Roughness.h"

namespace arris
{
/// The vertices of the mesh moved onto second-order surfaces through the input around them. Beyond
/// an edge the normals differ, and what differs there counts little: edges stay. Empty if the
/// monitor stopped it.
ARRISFILTERS_EXPORT std::vector<Vec3> DenoisedPoints(const Mesh& mesh,
  const Connectivity& connectivity, const std::vector<double>& scales, const Roughness& roughness,
  const Monitor& monitor);
}

#endif
