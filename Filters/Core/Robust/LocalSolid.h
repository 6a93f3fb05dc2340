// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file LocalSolid.h
/// The solid that a few sheets bound near a point: how they cut and join each other.

#ifndef arris_Robust_LocalSolid_h
#define arris_Robust_LocalSolid_h

#include "Sheet.h"

namespace arris
{
/// Two sheets meet convexly if each lies inside the other's half space, concavely if each lies
/// outside. The solid is then a tree: sheets that are convex to each other intersect (the largest
/// distance counts), concave ones unite (the smallest). Convex, concave and mixed corners are one
/// case.
class LocalSolid
{
public:
  void AddSheet(const Sheet& sheet, const std::vector<SheetSample>& samples);

  /// The distance of the solid's active sheet at the point; positive outside.
  double Value(const Vec3& point) const;

private:
  using Members = std::vector<int>;
  bool Convex(int a, int b) const
  {
    return this->MeanDistances[a][b] + this->MeanDistances[b][a] < 0.0;
  }
  double ValueOf(const Members& members, const std::vector<double>& distances) const;
  std::vector<Members> Groups(const Members& members, bool convex) const;

  std::vector<Sheet> Sheets;
  std::vector<std::vector<SheetSample>> Samples;

  /// How far the samples of one sheet are from another, on average. Where two sheets disagree on
  /// how they meet (one crosses the other), the larger of their distances is the clearer word.
  std::vector<std::vector<double>> MeanDistances;
};
}

#endif
