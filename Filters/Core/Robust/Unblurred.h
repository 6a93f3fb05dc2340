// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Unblurred.h
/// What a blur has moved beside edges, put back, so that sheets can be fitted to it.

#ifndef arris_Robust_Unblurred_h
#define arris_Robust_Unblurred_h

#include "Labelling.h"

namespace arris
{
/// The width (in local scales) of the Gaussian that explains best where the damaged vertices lie:
/// a blurred solid is where the blurred distance is zero. 0 if none explains them better.
double BlurWidth(
  const Surroundings& around, const std::vector<Index>& damaged, const Labelling& labelling);

/// A copy of what sides are fitted to, in which the vertices near edges lie where they would
/// without the blur, and those of the region that were moved little are intact.
struct Unblurred
{
  std::vector<Vec3> Points;
  std::vector<Vec3> Normals;
  std::vector<double> Flatness;
  Flags Region;
  Patches ThePatches;
  double Width;

  Unblurred(const Surroundings& around, const Samples& blurred, const std::vector<Index>& damaged,
    const Labelling& labelling, double width);

  Samples ToFit() const
  {
    return { this->Points, this->Normals, this->Flatness, this->Region, this->ThePatches,
      this->Width };
  }
};
}

#endif
