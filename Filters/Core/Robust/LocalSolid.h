// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file LocalSolid.h
/// The solid that a few sheets bound near a point: how they cut and join each other.

#ifndef arris_Robust_LocalSolid_h
#define arris_Robust_LocalSolid_h

#include "Sheet.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Two sheets meet convexly if each lies inside the other's half space, concavely if each lies
/// outside. The solid is then a tree: sheets that are convex to each other intersect (the largest
/// distance counts), concave ones unite (the smallest). Convex, concave and mixed corners are one
/// case.
class ARRISFILTERS_EXPORT LocalSolid
{
public:
  void AddSheet(const Sheet& sheet, const std::vector<SheetSample>& samples);

  /// Forgets the samples, which only further sheets need.
  void Close() { this->Samples = {}; }

  /// A distance, positive outside, and the direction in which it grows.
  struct Value
  {
    double Distance;
    Vec3 Normal;
  };

  /// The distance of the solid's active sheet at the point.
  double Distance(const Vec3& point) const;

  /// The same with its normal.
  Value SharpValue(const Vec3& point) const { return this->ValueAt(point, 0.0, true); }

  /// The same after a Gaussian of this width has blurred the distances: zero on the surface of the
  /// blurred solid.
  Value BlurredValue(const Vec3& point, double width) const
  {
    return this->ValueAt(point, width, true);
  }

private:
  using Members = std::vector<int>;
  bool Convex(int a, int b) const
  {
    return this->MeanDistances[a][b] + this->MeanDistances[b][a] < 0.0;
  }
  Value ValueAt(const Vec3& point, double width, bool normals) const;
  Value ValueOf(const Members& members, const std::vector<Value>& values, double width) const;
  std::vector<Members> Groups(const Members& members, bool convex) const;

  std::vector<Sheet> Sheets;
  std::vector<std::vector<SheetSample>> Samples;

  /// How far the samples of one sheet are from another, on average. Where two sheets disagree on
  /// how they meet (one crosses the other), the larger of their distances is the clearer word.
  std::vector<std::vector<double>> MeanDistances;
};
}

#endif
