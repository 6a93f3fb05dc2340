// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Sheet.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

constexpr int PlaneSteps = 3;
constexpr int QuadricSteps = 3;

/// A plane that leaves less than this (rms, in scales) is the surface: contours of exact distances
/// of planes leave their rounding, those of anything curved leave more.
constexpr double PlaneResidual = 0.005;

/// Fewer samples than this determine no quadric.
constexpr std::size_t LeastQuadricSamples = 9;

/// Pulls second order toward none; small, or curved sides are flattened (the largest single factor
/// in accuracy).
constexpr double CurvatureRidge = 1e-6;

/// Tukey's biweight: no weight beyond this many deviations.
constexpr double TukeyCut = 4.685;

/// Residuals under this (in scales) are never outliers.
constexpr double LeastDeviation = 0.0005;

Vec6 Basis(double u, double w)
{
  Vec6 basis;
  basis << 1.0, u, w, u * u, u * w, w * w;
  return basis;
}
}

Sheet::Sheet(
  const std::vector<SheetSample>& samples, const Vec3& center, double scale, double reach)
  : Origin(center)
  , Scale(scale)
  , Reach(reach / scale)
{
  std::vector<double> weights(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    weights[i] = samples[i].Weight;
  }
  for (int step = 0; step < PlaneSteps; ++step)
  {
    this->FitPlane(samples, weights);
    if (step + 1 < PlaneSteps)
    {
      this->Reweight(samples, weights);
    }
  }
  if (samples.size() < LeastQuadricSamples || this->Residual(samples, weights) < PlaneResidual)
  {
    return;
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    weights[i] = samples[i].Weight; // what a plane took for outliers may lie on the quadric
  }
  this->Curved = true;
  for (int step = 0; step < QuadricSteps; ++step)
  {
    this->FitQuadric(samples, weights);
    if (step + 1 < QuadricSteps)
    {
      this->Reweight(samples, weights);
    }
  }
}

void Sheet::FitPlane(const std::vector<SheetSample>& samples, std::vector<double>& weights)
{
  double sum = 0.0;
  Vec3 mean = Vec3::Zero();
  Vec3 outward = Vec3::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    sum += weights[i];
    mean += weights[i] * samples[i].Position;
    outward += weights[i] * samples[i].Normal;
  }
  if (!(sum > 0.0))
  {
    return;
  }
  mean /= sum;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Vec3 d = samples[i].Position - mean;
    covariance += weights[i] * d * d.transpose();
  }
  // Samples in a row, or fewer than three, leave the plane free to turn: their normals hold it.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  constexpr double Row = 1e-4;
  Vec3 normal = solver.eigenvectors().col(0);
  if (samples.size() < 3 || solver.eigenvalues()[1] < Row * solver.eigenvalues()[2])
  {
    normal = outward.norm() > 0.0 ? Vec3(outward.normalized()) : Vec3(Vec3::UnitZ());
  }
  this->N = normal.dot(outward) < 0.0 ? Vec3(-normal) : normal;
  this->U = this->N.unitOrthogonal();
  this->W = this->N.cross(this->U);
  this->Coefficients.setZero();
  this->Coefficients[0] = (mean - this->Origin).dot(this->N) / this->Scale;
}

void Sheet::FitQuadric(const std::vector<SheetSample>& samples, std::vector<double>& weights)
{
  Mat6 a = Mat6::Zero();
  Vec6 b = Vec6::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Vec3 d = (samples[i].Position - this->Origin) / this->Scale;
    const Vec6 basis = Basis(d.dot(this->U), d.dot(this->W));
    a += weights[i] * basis * basis.transpose();
    b += weights[i] * d.dot(this->N) * basis;
    sum += weights[i];
  }
  for (int k = 0; k < 6; ++k)
  {
    a(k, k) += (k < 3 ? 1e-12 : CurvatureRidge) * sum;
  }
  const Vec6 solution = a.ldlt().solve(b);
  if (solution.allFinite())
  {
    this->Coefficients = solution;
  }
}

double Sheet::Residual(
  const std::vector<SheetSample>& samples, const std::vector<double>& weights) const
{
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double r = this->Distance(samples[i].Position) / this->Scale;
    sum += weights[i];
    squares += weights[i] * r * r;
  }
  return sum > 0.0 ? std::sqrt(squares / sum) : 0.0;
}

void Sheet::Reweight(const std::vector<SheetSample>& samples, std::vector<double>& weights) const
{
  std::vector<double> residuals(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    residuals[i] = std::abs(this->Distance(samples[i].Position)) / this->Scale;
  }
  // The median by weight, as the samples that matter are the ones near.
  std::vector<std::size_t> order(samples.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::sort(order.begin(), order.end(),
    [&](std::size_t i, std::size_t j)
    { return residuals[i] != residuals[j] ? residuals[i] < residuals[j] : i < j; });
  double half = 0.0;
  for (const SheetSample& sample : samples)
  {
    half += 0.5 * sample.Weight;
  }
  double median = 0.0;
  for (std::size_t i : order)
  {
    half -= samples[i].Weight;
    if (half <= 0.0)
    {
      median = residuals[i];
      break;
    }
  }
  const double cut = TukeyCut * std::max(1.4826 * median, LeastDeviation);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double x = residuals[i] / cut;
    const double keep = x < 1.0 ? (1.0 - x * x) * (1.0 - x * x) : 0.0;
    weights[i] = samples[i].Weight * keep;
  }
}

Sheet::HeightAndSlope Sheet::At(double u, double w) const
{
  const Vec6& c = this->Coefficients;
  if (!this->Curved)
  {
    return { c[0], 0.0, 0.0 };
  }
  const double length = std::hypot(u, w);
  const double shrink = length > this->Reach ? this->Reach / length : 1.0;
  const double bu = u * shrink, bw = w * shrink;
  const double slopeU = c[1] + 2.0 * c[3] * bu + c[4] * bw;
  const double slopeW = c[2] + 2.0 * c[5] * bw + c[4] * bu;
  const double height = Basis(bu, bw).dot(c) + slopeU * (u - bu) + slopeW * (w - bw);
  return { height, slopeU, slopeW };
}

double Sheet::Distance(const Vec3& point) const
{
  const Vec3 d = (point - this->Origin) / this->Scale;
  const HeightAndSlope at = this->At(d.dot(this->U), d.dot(this->W));
  return this->Scale * (d.dot(this->N) - at.Height) /
    std::sqrt(1.0 + at.SlopeU * at.SlopeU + at.SlopeW * at.SlopeW);
}

Vec3 Sheet::Normal(const Vec3& point) const
{
  const Vec3 d = (point - this->Origin) / this->Scale;
  const HeightAndSlope at = this->At(d.dot(this->U), d.dot(this->W));
  return (this->N - at.SlopeU * this->U - at.SlopeW * this->W).normalized();
}
}
