// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Sheet.h
/// A smooth face carried on beyond its border: a plane, or a quadric height field over one.

#ifndef arris_Robust_Sheet_h
#define arris_Robust_Sheet_h

#include "Core/Types.h"

namespace arris
{
/// A point that a sheet is fitted to.
struct SheetSample
{
  Vec3 Position;
  Vec3 Normal; ///< decides which side of the sheet is outside; the fit does not use it
  double Weight;
};

class Sheet
{
public:
  Sheet() = default;

  /// Fits a plane by reweighted least squares, and where that leaves more than noise (`scale` is
  /// the local edge length), a quadric. `reach` is how far from `center` second order is believed;
  /// beyond it the sheet goes on straight. At least one sample.
  Sheet(const std::vector<SheetSample>& samples, const Vec3& center, double scale, double reach);

  /// Distance from the sheet, to first order; positive outside.
  double Distance(const Vec3& point) const;

  /// Unit normal of the sheet below the point, outward.
  Vec3 Normal(const Vec3& point) const;

private:
  struct HeightAndSlope
  {
    double Height, SlopeU, SlopeW;
  };
  HeightAndSlope At(double u, double w) const;
  void FitPlane(const std::vector<SheetSample>& samples, std::vector<double>& weights);
  void FitQuadric(const std::vector<SheetSample>& samples, std::vector<double>& weights);
  double Residual(
    const std::vector<SheetSample>& samples, const std::vector<double>& weights) const;
  void Reweight(const std::vector<SheetSample>& samples, std::vector<double>& weights) const;

  Vec3 Origin = Vec3::Zero();
  Vec3 U = Vec3::UnitX();
  Vec3 W = Vec3::UnitY();
  Vec3 N = Vec3::UnitZ();
  double Scale = 1.0;
  double Reach = 1.0; // in scales
  bool Curved = false;
  Eigen::Matrix<double, 6, 1> Coefficients = Eigen::Matrix<double, 6, 1>::Zero(); // 1 u w uu uw ww
};
}

#endif
