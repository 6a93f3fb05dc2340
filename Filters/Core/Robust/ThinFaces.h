// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ThinFaces.h
/// Keeps something intact on faces so narrow that the sharp region covers them.

#ifndef arris_Robust_ThinFaces_h
#define arris_Robust_ThinFaces_h

#include "Faces.h"

namespace arris
{
/// Takes out of the region the vertices that are flat all around and whose face no intact vertex
/// nearby speaks for: the middle of slot floors and webs.
void SpareThinFaces(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& scales, Flags& region);
}

#endif
