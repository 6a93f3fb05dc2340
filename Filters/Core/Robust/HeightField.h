// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file HeightField.h
/// A second-order height over a tangent plane, fitted by least squares.

#ifndef arris_Robust_HeightField_h
#define arris_Robust_HeightField_h

#include "Core/Types.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace arris
{
/// A frame at a point, its third axis the normal; lengths are divided by a scale.
struct TangentFrame
{
  Vec3 Origin;
  Vec3 U;
  Vec3 W;
  Vec3 N;
  double Scale;

  TangentFrame(const Vec3& origin, const Vec3& normal, double scale)
    : Origin(origin)
    , U(normal.unitOrthogonal())
    , W(normal.cross(this->U))
    , N(normal)
    , Scale(scale)
  {
  }

  /// The coordinates of a point: along U, along W, height.
  Vec3 Local(const Vec3& point) const
  {
    const Vec3 d = (point - this->Origin) / this->Scale;
    return { d.dot(this->U), d.dot(this->W), d.dot(this->N) };
  }
};

/// Accumulates points and solves for the height 1, u, w, u², uw, w².
class HeightField
{
public:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  using Mat6 = Eigen::Matrix<double, 6, 6>;

  static Vec6 Basis(double u, double w)
  {
    Vec6 basis;
    basis << 1.0, u, w, u * u, u * w, w * w;
    return basis;
  }

  void Add(const Vec3& local, double weight)
  {
    const Vec6 basis = Basis(local[0], local[1]);
    this->Left.selfadjointView<Eigen::Lower>().rankUpdate(basis, weight);
    this->Right += weight * local[2] * basis;
    this->Weight += weight;
  }

  /// `secondOrderRidge` pulls the curvature toward none, per unit of weight.
  Vec6 Solve(double secondOrderRidge) const
  {
    Mat6 left = this->Left.selfadjointView<Eigen::Lower>();
    constexpr double Tiny = 1e-12; // keeps what too few points leave open at zero
    for (int k = 0; k < 6; ++k)
    {
      left(k, k) += this->Weight * (k < 3 ? Tiny : secondOrderRidge);
    }
    return left.ldlt().solve(this->Right);
  }

private:
  Mat6 Left = Mat6::Zero();
  Vec6 Right = Vec6::Zero();
  double Weight = 0.0;
};
}

#endif
