// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalSpread.h"

#include <algorithm>
#include <cmath>

namespace arris
{
double NormalSpread::Largest(
  const std::vector<Index>& triangles, const std::vector<Vec3>& unitNormals)
{
  // The chord between two normals is at most the sum of their chords to any third direction. With
  // that third one in the middle of the set and the normals sorted by their chord to it, farthest
  // first, the search ends as soon as the sum falls under the best pair: almost at once. Chords
  // rather than cosines, as these cancel where normals are nearly equal.
  Vec3 axis = Vec3::Zero();
  this->Entries.clear();
  for (Index t : triangles)
  {
    if (!unitNormals[t].isZero(0.0))
    {
      this->Entries.push_back({ 0.0, t });
      axis += unitNormals[t];
    }
  }
  if (this->Entries.size() < 2)
  {
    return 0.0;
  }
  axis.normalize(); // stays zero if the normals cancel, and the bound still holds
  for (Entry& entry : this->Entries)
  {
    entry.ToAxis = (unitNormals[entry.Triangle] - axis).norm();
  }
  std::sort(this->Entries.begin(), this->Entries.end(),
    [](const Entry& a, const Entry& b)
    { return a.ToAxis > b.ToAxis || (a.ToAxis == b.ToAxis && a.Triangle < b.Triangle); });

  double best2 = 0.0;
  double best = 0.0;
  for (std::size_t i = 0; i + 1 < this->Entries.size(); ++i)
  {
    if (this->Entries[i].ToAxis + this->Entries[i + 1].ToAxis <= best)
    {
      break;
    }
    for (std::size_t j = i + 1; j < this->Entries.size(); ++j)
    {
      if (this->Entries[i].ToAxis + this->Entries[j].ToAxis <= best)
      {
        break;
      }
      const double chord2 =
        (unitNormals[this->Entries[i].Triangle] - unitNormals[this->Entries[j].Triangle])
          .squaredNorm();
      if (chord2 > best2)
      {
        best2 = chord2;
        best = std::sqrt(chord2);
      }
    }
  }
  return std::min(2.0, 0.5 * best2);
}
}
