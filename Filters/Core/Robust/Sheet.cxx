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
constexpr int CurvedSteps = 6;
constexpr int CurvedReweights = 2;

/// No sampling shows a surface bent tighter than this, in radians a scale.
constexpr double MostBending = 0.5;

/// Fewer samples than this determine no curvature.
constexpr std::size_t LeastCurvedSamples = 9;

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

/// How far (u, z) is above the circle of this curvature that touches the u axis at the origin from
/// above; well-behaved as the circle becomes a line.
double FromCircle(double curvature, double u, double z)
{
  const double twice = 2.0 * z - curvature * (u * u + z * z);
  return twice / (1.0 + std::sqrt(std::max(0.0, 1.0 - curvature * twice)));
}
}

Sheet::Sheet(const std::vector<SheetSample>& samples, double scale, const SheetCaution& caution)
  : Scale(scale)
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
  const double flat = this->Residual(samples, weights);
  if (samples.size() < LeastCurvedSamples || flat < caution.FlatResidual)
  {
    return;
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    weights[i] = samples[i].Weight; // what a plane took for outliers may lie on the torus
  }
  const Sheet plane = *this;
  for (int step = 0; step < CurvedSteps; ++step)
  {
    if (!this->Bend(samples, weights, caution.Ridge))
    {
      *this = plane;
      return;
    }
    if (step > 0 && step <= CurvedReweights)
    {
      this->Reweight(samples, weights);
    }
  }
  if (flat < caution.CurvedGain * this->Residual(samples, weights))
  {
    *this = plane;
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
  this->Origin = mean;
}

bool Sheet::Bend(
  const std::vector<SheetSample>& samples, const std::vector<double>& weights, double ridge)
{
  Mat6 a = Mat6::Zero();
  Vec6 b = Vec6::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Vec3 d = (samples[i].Position - this->Origin) / this->Scale;
    const Vec6 basis = Basis(d.dot(this->U), d.dot(this->W));
    a += weights[i] * basis * basis.transpose();
    b += weights[i] * this->Distance(samples[i].Position) / this->Scale * basis;
    sum += weights[i];
  }
  for (int k = 0; k < 6; ++k)
  {
    a(k, k) += (k < 3 ? 1e-12 : ridge) * sum;
  }
  const Vec6 change = a.ldlt().solve(b);
  if (!change.allFinite())
  {
    return false;
  }
  Eigen::Matrix2d bending;
  bending << this->BendingU + 2.0 * change[3], change[4], change[4],
    this->BendingW + 2.0 * change[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(bending);
  this->Origin += this->Scale * change[0] * this->N;
  const Vec3 u = this->U, w = this->W;
  this->N = (this->N - change[1] * u - change[2] * w).normalized();
  const Eigen::Vector2d direction = principal.eigenvectors().col(0);
  this->U = direction[0] * u + direction[1] * w;
  this->U = (this->U - this->U.dot(this->N) * this->N).normalized();
  this->W = this->N.cross(this->U);
  this->BendingU = std::clamp(principal.eigenvalues()[0], -MostBending, MostBending);
  this->BendingW = std::clamp(principal.eigenvalues()[1], -MostBending, MostBending);
  return true;
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

void Sheet::Unblur(double width)
{
  const double moved = 0.5 * width * width * (this->BendingU + this->BendingW) / this->Scale;
  this->Origin -= moved * this->N;
}

double Sheet::Distance(const Vec3& point) const
{
  const Vec3 d = (point - this->Origin) / this->Scale;
  const double height = FromCircle(this->BendingW, d.dot(this->W), d.dot(this->N));
  return this->Scale * FromCircle(this->BendingU, d.dot(this->U), height);
}

Vec3 Sheet::Normal(const Vec3& point) const
{
  const Vec3 d = (point - this->Origin) / this->Scale;
  const double u = d.dot(this->U), w = d.dot(this->W), z = d.dot(this->N);
  const double height = FromCircle(this->BendingW, w, z);
  const Vec3 inner = (1.0 - this->BendingW * z) * this->N - this->BendingW * w * this->W;
  const Vec3 normal =
    (1.0 - this->BendingU * height) * inner.normalized() - this->BendingU * u * this->U;
  return normal.squaredNorm() > 0.0 ? Vec3(normal.normalized()) : this->N;
}
}
