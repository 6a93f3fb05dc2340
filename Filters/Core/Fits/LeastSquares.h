// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file LeastSquares.h
/// Solves the normal equations of the fits.

#ifndef arris_Fits_LeastSquares_h
#define arris_Fits_LeastSquares_h

#include <Eigen/Core>

namespace arris
{
/// The x of the least length for which matrix * x comes nearest to right: also where the equations
/// leave something open. One function for all sizes, as Eigen's decomposition takes a compiler ten
/// seconds for each.
Eigen::MatrixXd SolveLeastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
}

#endif
