// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Predictor.h
/// The geometry predictor: where tangent planes nearby say a vertex belongs
/// (sections 3.2 and 4.3, Eqs. 3 to 9).

#ifndef arris_Predictor_h
#define arris_Predictor_h

#include "Types.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The system CX = B of Eq. 9: the sum, over planes, of squared distances to them, about a centre.
class ARRISFILTERS_EXPORT Predictor
{
public:
  /// `center` is p_c, from where the translation X starts and where the planes leave it free.
  explicit Predictor(const Vec3& center)
    : Center(center)
  {
  }

  /// Adds the plane through `point` with unit normal `normal`.
  void AddPlane(const Vec3& point, const Vec3& normal, double weight)
  {
    this->C.noalias() += weight * normal * normal.transpose();
    this->B += weight * normal.dot(point - this->Center) * normal;
  }

  /// The weights of all planes together.
  double Weight() const { return this->C.trace(); }

  /// p_c + X for the X of least norm that solves CX = B, cut to `longest` (the paper: 4 L).
  /// Directions whose eigenvalue of C is under `SmallEigenvalue` times the largest are left free,
  /// as the singular value decomposition of the paper does.
  /// So are all but the `most` largest.
  Vec3 Position(double longest, int most = 3) const;

  /// Below this part of the largest eigenvalue the planes are taken to agree: normals that differ
  /// by less than about 8° (sin² 8° = 0.02, as two equal planes at angle a have the eigenvalues
  /// 1 ± cos a) differ by sampling, and their cut would lie far away.
  static constexpr double SmallEigenvalue = 0.005;

private:
  Vec3 Center;
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  Vec3 B = Vec3::Zero();
};
}

#endif
