// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file NormalSpread.h
/// The largest difference between two normals of a set: the supremum in the paper's Eq. 2.

#ifndef arris_NormalSpread_h
#define arris_NormalSpread_h

#include "Types.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Finds max(1 - ni.nj) exactly without looking at every pair. Keeps its working memory from one
/// call to the next: use one object a thread.
class ARRISFILTERS_EXPORT NormalSpread
{
public:
  /// The largest 1 - ni.nj over the triangles listed, 0 to 2. Zero normals (slivers) do not count.
  double Largest(const std::vector<Index>& triangles, const std::vector<Vec3>& unitNormals);

private:
  /// Which of the normals is farthest from a direction, and the squares of all their chords to it.
  std::size_t FarthestFrom(const Vec3& direction, std::vector<double>& chords2) const;

  /// The largest square of a chord between two normals, if it is over `best2`; `best2` otherwise.
  double LargestOver(double best2, double mostToAxis2);

  struct Entry
  {
    double ToAxis; ///< chord from the normal to the axis of the set
    std::size_t Normal;
  };
  std::vector<Vec3> Normals;
  std::vector<double> ToAxis2, ToFirst2; ///< squares of chords
  std::vector<Entry> Farthest;
};
}

#endif
