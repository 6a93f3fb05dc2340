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
  this->Normals.clear();
  Vec3 axis = Vec3::Zero();
  for (const Index t : triangles)
  {
    const Vec3& normal = unitNormals[t];
    if (!normal.isZero(0.0))
    {
      this->Normals.push_back(normal);
      axis += normal;
    }
  }
  if (this->Normals.size() < 2)
  {
    return 0.0;
  }
  axis.normalize(); // stays zero if the normals cancel, and the bound below still holds

  // The normal farthest from the middle of the set, and the one farthest from that, are nearly
  // always the two sought. Chords rather than cosines, as these cancel where normals are nearly
  // equal.
  const std::size_t first = this->FarthestFrom(axis, this->ToAxis2);
  const std::size_t second = this->FarthestFrom(this->Normals[first], this->ToFirst2);
  return std::min(2.0, 0.5 * this->LargestOver(this->ToFirst2[second], this->ToAxis2[first]));
}

std::size_t NormalSpread::FarthestFrom(const Vec3& direction, std::vector<double>& chords2) const
{
  chords2.resize(this->Normals.size());
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < this->Normals.size(); ++i)
  {
    chords2[i] = (this->Normals[i] - direction).squaredNorm();
    farthest = chords2[i] > chords2[farthest] ? i : farthest;
  }
  return farthest;
}

double NormalSpread::LargestOver(double best2, double mostToAxis2)
{
  // The chord between two normals is at most the sum of their chords to any third direction. So
  // both of a better pair are farther from the axis than this.
  double best = std::sqrt(best2);
  const double least = best - std::sqrt(mostToAxis2);
  this->Farthest.clear();
  for (std::size_t i = 0; best > 0.0 && i < this->Normals.size(); ++i)
  {
    if (least < 0.0 || this->ToAxis2[i] > least * least)
    {
      this->Farthest.push_back({ std::sqrt(this->ToAxis2[i]), i });
    }
  }
  std::sort(this->Farthest.begin(), this->Farthest.end(),
    [](const Entry& a, const Entry& b) { return a.ToAxis > b.ToAxis; });
  for (std::size_t i = 0; i + 1 < this->Farthest.size(); ++i)
  {
    const Entry& one = this->Farthest[i];
    for (std::size_t j = i + 1; j < this->Farthest.size(); ++j)
    {
      const Entry& other = this->Farthest[j];
      if (one.ToAxis + other.ToAxis <= best)
      {
        break;
      }
      const double chord2 = (this->Normals[one.Normal] - this->Normals[other.Normal]).squaredNorm();
      if (chord2 > best2)
      {
        best2 = chord2;
        best = std::sqrt(chord2);
      }
    }
  }
  return best2;
}
}
