// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Sheet.h
/// A smooth face carried on beyond its border: a plane, or a quadric height field over one.

#ifndef arris_Robust_Sheet_h
#define arris_Robust_Sheet_h

#include "Core/Types.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <algorithm>
#include <cmath>

namespace arris
{
/// A point that a sheet is fitted to.
struct SheetSample
{
  Vec3 Position;
  Vec3 Normal; ///< decides which side of the sheet is outside; the fit does not use it
  double Weight;
};

/// When a plane is given up for a torus; by default on clean samples.
struct SheetCaution
{
  /// How many times as much a plane must leave as a torus.
  double CurvedGain = 1.5;

  /// A plane that leaves less than this (rms, in scales) is the surface: contours of exact
  /// distances of planes leave their rounding, those of anything curved leave more.
  double FlatResidual = 0.0005;

  /// Pulls second order toward none; small, or curved sides are flattened (the largest single
  /// factor in accuracy).
  double Ridge = 1e-6;
};

class ARRISFILTERS_EXPORT Sheet
{
public:
  Sheet() = default;

  /// Fits a plane by reweighted least squares, and where a torus leaves much less, that: it has two
  /// curvatures, and is exact for planes, cylinders, spheres and tori. `scale` is the local edge
  /// length. At least one sample.
  Sheet(const std::vector<SheetSample>& samples, double scale, const SheetCaution& caution);

  /// A plane.
  Sheet(const Vec3& point, const Vec3& unitNormal);

  /// Puts a bent sheet back to where it was before its distances were blurred by a Gaussian of this
  /// width, which moves a surface by half the squared width times the sum of its curvatures.
  void Unblur(double width);

  /// Distance from the sheet, to first order; positive outside.
  double Distance(const Vec3& point) const;

  bool IsFlat() const { return this->BendingU == 0.0 && this->BendingW == 0.0; }

  /// The larger of its two curvatures, the inverse of a radius in scales.
  double Curvature() const { return std::max(std::abs(this->BendingU), std::abs(this->BendingW)); }

  /// Unit normal of the sheet below the point, outward.
  Vec3 Normal(const Vec3& point) const;

private:
  struct Fitting; // the samples, how much each counts by now, and how far off the sheet it is
  void FitPlane(Fitting& fitting);
  bool Bend(Fitting& fitting, double ridge);
  void MeasureDistances(Fitting& fitting) const;
  double Residual(const Fitting& fitting) const;
  void Reweight(Fitting& fitting) const;

  Vec3 Origin = Vec3::Zero();
  Vec3 U = Vec3::UnitX();
  Vec3 W = Vec3::UnitY();
  Vec3 N = Vec3::UnitZ();
  double Scale = 1.0;
  double BendingU = 0.0; ///< curvature along U, the inverse of a radius in scales; toward N
  double BendingW = 0.0;
};
}

#endif
