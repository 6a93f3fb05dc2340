// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Sheet.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

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

/// A plane is not fitted again to fewer samples: one that outweighs all others takes them for
/// outliers, and what is left would turn with its rounding.
constexpr std::size_t LeastPlaneSamples = 3;

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

struct Sheet::Fitting
{
  explicit Fitting(const std::vector<SheetSample>& samples)
    : Samples(samples)
    , Weights(samples.size())
    , Distances(samples.size())
    , Order(samples.size())
  {
    this->ResetWeights();
    for (const SheetSample& sample : samples)
    {
      this->HalfWeight += 0.5 * sample.Weight;
    }
  }

  void ResetWeights()
  {
    for (std::size_t i = 0; i < this->Samples.size(); ++i)
    {
      this->Weights[i] = this->Samples[i].Weight;
    }
  }

  std::size_t CountingSamples() const
  {
    return static_cast<std::size_t>(std::count_if(
      this->Weights.begin(), this->Weights.end(), [](double weight) { return weight > 0.0; }));
  }

  const std::vector<SheetSample>& Samples;
  std::vector<double> Weights;
  std::vector<double> Distances; ///< from the sheet as it was last measured
  std::vector<std::pair<double, std::size_t>> Order; ///< residuals and whose they are
  double HalfWeight = 0.0; ///< of all samples as they came
};

Sheet::Sheet(const std::vector<SheetSample>& samples, double scale, const SheetCaution& caution)
  : Scale(scale)
{
  Fitting fitting(samples);
  this->FitPlane(fitting);
  this->MeasureDistances(fitting);
  for (int step = 1; step < PlaneSteps; ++step)
  {
    this->Reweight(fitting);
    if (fitting.CountingSamples() >= LeastPlaneSamples)
    {
      this->FitPlane(fitting);
      this->MeasureDistances(fitting);
    }
  }
  const double flat = this->Residual(fitting);
  if (samples.size() < LeastCurvedSamples || flat < caution.FlatResidual)
  {
    return;
  }
  fitting.ResetWeights(); // what a plane took for outliers may lie on the torus
  const Sheet plane = *this;
  for (int step = 0; step < CurvedSteps; ++step)
  {
    if (!this->Bend(fitting, caution.Ridge))
    {
      *this = plane;
      return;
    }
    this->MeasureDistances(fitting);
    if (step > 0 && step <= CurvedReweights)
    {
      this->Reweight(fitting);
    }
  }
  if (flat < caution.CurvedGain * this->Residual(fitting))
  {
    *this = plane;
  }
}

Sheet::Sheet(const Vec3& point, const Vec3& unitNormal)
  : Origin(point)
  , U(unitNormal.unitOrthogonal())
  , W(unitNormal.cross(this->U))
  , N(unitNormal)
{
}

void Sheet::FitPlane(Fitting& fitting)
{
  const std::vector<SheetSample>& samples = fitting.Samples;
  const std::vector<double>& weights = fitting.Weights;
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
  // Samples in a row leave the plane free to turn: their normals hold it.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  constexpr double Row = 1e-4;
  Vec3 normal = solver.eigenvectors().col(0);
  if (solver.eigenvalues()[1] < Row * solver.eigenvalues()[2])
  {
    normal = outward.norm() > 0.0 ? Vec3(outward.normalized()) : Vec3(Vec3::UnitZ());
  }
  this->N = normal.dot(outward) < 0.0 ? Vec3(-normal) : normal;
  this->U = this->N.unitOrthogonal();
  this->W = this->N.cross(this->U);
  this->Origin = mean;
}

bool Sheet::Bend(Fitting& fitting, double ridge)
{
  const std::vector<SheetSample>& samples = fitting.Samples;
  const std::vector<double>& weights = fitting.Weights;
  Mat6 a = Mat6::Zero(); // its lower half, which is all that the solver reads
  Vec6 b = Vec6::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Vec3 d = (samples[i].Position - this->Origin) / this->Scale;
    const Vec6 basis = Basis(d.dot(this->U), d.dot(this->W));
    const Vec6 weighted = weights[i] * basis;
    for (int column = 0; column < 6; ++column)
    {
      for (int row = column; row < 6; ++row)
      {
        a(row, column) += weighted[row] * basis[column];
      }
    }
    b += weights[i] * fitting.Distances[i] / this->Scale * basis;
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

void Sheet::MeasureDistances(Fitting& fitting) const
{
  for (std::size_t i = 0; i < fitting.Samples.size(); ++i)
  {
    fitting.Distances[i] = this->Distance(fitting.Samples[i].Position);
  }
}

double Sheet::Residual(const Fitting& fitting) const
{
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < fitting.Samples.size(); ++i)
  {
    const double r = fitting.Distances[i] / this->Scale;
    sum += fitting.Weights[i];
    squares += fitting.Weights[i] * r * r;
  }
  return sum > 0.0 ? std::sqrt(squares / sum) : 0.0;
}

void Sheet::Reweight(Fitting& fitting) const
{
  const std::vector<SheetSample>& samples = fitting.Samples;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    fitting.Order[i] = { std::abs(fitting.Distances[i]) / this->Scale, i };
  }
  // The median by weight, as the samples that matter are the ones near.
  std::sort(fitting.Order.begin(), fitting.Order.end());
  double half = fitting.HalfWeight;
  double median = 0.0;
  for (const auto& [residual, i] : fitting.Order)
  {
    half -= samples[i].Weight;
    if (half <= 0.0)
    {
      median = residual;
      break;
    }
  }
  const double cut = TukeyCut * std::max(1.4826 * median, LeastDeviation);
  for (const auto& [residual, i] : fitting.Order)
  {
    const double x = residual / cut;
    const double keep = x < 1.0 ? (1.0 - x * x) * (1.0 - x * x) : 0.0;
    fitting.Weights[i] = samples[i].Weight * keep;
  }
}

void Sheet::Unblur(double width)
{
  // Away from the middle of a bend its radii are larger, so how far it was moved depends on itself.
  constexpr int Steps = 4;
  const double w = width / this->Scale;
  const double u = this->BendingU, v = this->BendingW;
  double outward = 0.0;
  for (int step = 0; step < Steps; ++step)
  {
    outward = -0.5 * w * w * (u / (1.0 - u * outward) + v / (1.0 - v * outward));
  }
  this->Origin += outward * this->Scale * this->N;
  this->BendingU = u / (1.0 - u * outward);
  this->BendingW = v / (1.0 - v * outward);
}

double Sheet::Distance(const Vec3& point) const
{
  const Vec3 d = (point - this->Origin) / this->Scale;
  if (this->IsFlat())
  {
    return this->Scale * d.dot(this->N); // to the bit what follows would give
  }
  const double height = FromCircle(this->BendingW, d.dot(this->W), d.dot(this->N));
  return this->Scale * FromCircle(this->BendingU, d.dot(this->U), height);
}

Vec3 Sheet::Normal(const Vec3& point) const
{
  if (this->IsFlat())
  {
    return this->N;
  }
  const Vec3 d = (point - this->Origin) / this->Scale;
  const double u = d.dot(this->U), w = d.dot(this->W), z = d.dot(this->N);
  const double height = FromCircle(this->BendingW, w, z);
  const Vec3 inner = (1.0 - this->BendingW * z) * this->N - this->BendingW * w * this->W;
  const Vec3 normal =
    (1.0 - this->BendingU * height) * inner.normalized() - this->BendingU * u * this->U;
  return normal.squaredNorm() > 0.0 ? Vec3(normal.normalized()) : this->N;
}
}
