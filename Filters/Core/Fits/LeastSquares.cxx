// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LeastSquares.h"

#include <Eigen/QR>

namespace arris
{
Eigen::MatrixXd SolveLeastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right)
{
  return matrix.completeOrthogonalDecomposition().solve(right);
}
}
