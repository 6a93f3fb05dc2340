// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Predictor.h"

#include <Eigen/Eigenvalues>

namespace arris
{
Vec3 Predictor::Position(double longest, int most) const
{
  // C is symmetric and positive, so its eigenvectors are its singular vectors.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(this->C);
  const double least = SmallEigenvalue * solver.eigenvalues()[2];
  Vec3 translation = Vec3::Zero();
  for (int i = 3 - most; i < 3; ++i)
  {
    const double eigenvalue = solver.eigenvalues()[i];
    if (eigenvalue > least)
    {
      const Vec3 direction = solver.eigenvectors().col(i);
      translation += direction.dot(this->B) / eigenvalue * direction;
    }
  }
  const double length = translation.norm();
  if (length > longest)
  {
    translation *= longest / length;
  }
  return this->Center + translation;
}
}
