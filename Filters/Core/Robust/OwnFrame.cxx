// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnFrame.h"

#include "Core/Box.h"
#include "Core/EdgeLengths.h"
#include "Core/ExactSum.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <mutex>

namespace arris
{
namespace
{
/// In mean edges. Single precision rounds the vertices of a part a hundred edges wide to a thousand
/// times this, double precision to less than a millionth.
constexpr double GridWidth = 1.0 / (1 << 28);

/// A mesh wider than this, in mean edges, is left where it is: its coordinates have no digits for
/// this grid.
constexpr double WidestMesh = 1 << 20;

/// Two principal moments closer than this, as a part of the largest, have no axes of their own:
/// rounding would turn them. A skewness smaller than this does not tell ahead from behind.
constexpr double LeastDifference = 1e-6;
constexpr double LeastSkewness = 1e-6;

/// The vertices that triangles name, and their moments.
class Cloud
{
public:
  Cloud(const Mesh& mesh, const Connectivity& connectivity)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
  {
    Box box = Box::Empty();
    std::mutex mutex;
    ParallelFor(mesh.VertexCount(),
      [&](Index begin, Index end)
      {
        Box own = Box::Empty();
        for (Index v = begin; v < end; ++v)
        {
          if (this->IsNamed(v))
          {
            own.Include(mesh.Points[v]);
          }
        }
        const std::lock_guard<std::mutex> lock(mutex);
        box.Include(own);
      });
    this->Centre = 0.5 * (box.Low + box.High);
    this->Width = (box.High - box.Low).norm();
  }

  /// The mean of a vector that is a function of the vertices, no longer than 1.
  template <std::size_t Size, typename Function>
  Eigen::Matrix<double, Size, 1> Mean(Function&& function) const
  {
    const auto sums = ExactSums<Size + 1>(this->TheMesh.VertexCount(),
      [&](Index v, auto& own)
      {
        if (!this->IsNamed(v))
        {
          return;
        }
        const Eigen::Matrix<double, Size, 1> values = function(this->TheMesh.Points[v]);
        for (std::size_t k = 0; k < Size; ++k)
        {
          own[k].Add(values[k]);
        }
        own[Size].Add(1.0);
      });
    Eigen::Matrix<double, Size, 1> mean;
    for (std::size_t k = 0; k < Size; ++k)
    {
      mean[k] = sums[k].Value() / sums[Size].Value();
    }
    return mean;
  }

  Vec3 Centre; ///< of the box around them
  double Width; ///< its diagonal

private:
  bool IsNamed(Index v) const { return !this->TheConnectivity.TrianglesOfVertex[v].empty(); }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
};

/// The principal axes, as rows; those of the coordinates where the moments do not tell them apart.
Eigen::Matrix3d PrincipalAxes(const Cloud& cloud, const Vec3& origin)
{
  const auto second = cloud.Mean<6>(
    [&](const Vec3& point)
    {
      const Vec3 d = (point - origin) / cloud.Width;
      Eigen::Matrix<double, 6, 1> products;
      products << d.x() * d.x(), d.x() * d.y(), d.x() * d.z(), d.y() * d.y(), d.y() * d.z(),
        d.z() * d.z();
      return products;
    });
  Eigen::Matrix3d moments;
  moments << second[0], second[1], second[2], second[1], second[3], second[4], second[2], second[4],
    second[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  const Vec3 values = solver.eigenvalues(); // ascending
  const double least = std::min(values[1] - values[0], values[2] - values[1]);
  if (!(least > LeastDifference * values[2]))
  {
    return Eigen::Matrix3d::Identity();
  }
  return solver.eigenvectors().transpose();
}

/// Turns axes round whose other half reaches farther; towards those of the coordinates if neither
/// does.
void LookAhead(const Cloud& cloud, const Vec3& origin, Eigen::Matrix3d& axes)
{
  const auto moments = cloud.Mean<6>(
    [&](const Vec3& point)
    {
      const Eigen::Array3d own = axes * (point - origin) / cloud.Width;
      Eigen::Matrix<double, 6, 1> powers;
      powers << own.square(), own.cube();
      return powers;
    });
  for (int k = 0; k < 3; ++k)
  {
    const double third = moments[3 + k];
    const bool isTold = std::abs(third) > LeastSkewness * std::pow(moments[k], 1.5);
    Index along = 0;
    axes.row(k).cwiseAbs().maxCoeff(&along);
    if ((isTold ? third : axes(k, along)) < 0.0)
    {
      axes.row(k) *= -1.0;
    }
  }
}
}

OwnFrame::OwnFrame(const Mesh& mesh, const Connectivity& connectivity)
{
  const Cloud cloud(mesh, connectivity);
  const double edge = GeometricMeanEdgeLength(mesh, connectivity);
  if (!(cloud.Width > 0.0 && cloud.Width < WidestMesh * edge))
  {
    return;
  }
  this->Origin = cloud.Centre +
    cloud.Width *
      cloud.Mean<3>(
        [&](const Vec3& point) -> Vec3 { return (point - cloud.Centre) / cloud.Width; });
  this->Axes = PrincipalAxes(cloud, this->Origin);
  LookAhead(cloud, this->Origin, this->Axes);
  this->UnitLength = edge;
  this->Grid = GridWidth;
}

Vec3 OwnFrame::Into(const Vec3& point) const
{
  const Vec3 own = this->Axes * (point - this->Origin) / this->UnitLength;
  if (this->Grid == 0.0)
  {
    return own;
  }
  return own.unaryExpr([this](double x) { return std::nearbyint(x / this->Grid) * this->Grid; });
}

Vec3 OwnFrame::Back(const Vec3& point) const
{
  return this->Origin + this->Axes.transpose() * (this->UnitLength * point);
}
}
