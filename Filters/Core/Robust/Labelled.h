// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Labelled.h
/// A mesh with all that is known about its damaged vertices.

#ifndef arris_Robust_Labelled_h
#define arris_Robust_Labelled_h

#include "Labelling.h"

namespace arris
{
struct Labelled
{
  const Mesh& Before; ///< as the vertices came
  const Mesh& Now; ///< what the pass has started from
  const Mesh& Safe; ///< of the two the one that vertices retreat to
  const Connectivity& TheConnectivity;
  const Labelling& Labels;
  const std::vector<double>& Scales;
  const Flags& Region;
};
}

#endif
