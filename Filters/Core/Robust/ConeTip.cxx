// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeTip.h"

#include "Core/Predictor.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris
{
namespace
{
double NearestTo(const TangentPlanes& planes, const Vec3& tip)
{
  double least = std::numeric_limits<double>::max();
  for (const Vec3& point : planes.Points)
  {
    least = std::min(least, (point - tip).norm());
  }
  return least;
}

/// The tip at which planes pass at `blur` over their distance.
ConeTip TipAt(const TangentPlanes& planes, const Vec3& tip, double blur)
{
  double squares = 0.0;
  for (std::size_t i = 0; i < planes.Points.size(); ++i)
  {
    const Vec3 away = tip - planes.Points[i];
    const double off = planes.Normals[i].dot(away) - blur / away.norm();
    squares += off * off;
  }
  return { tip, std::sqrt(squares / static_cast<double>(planes.Points.size())),
    std::abs(blur) / NearestTo(planes, tip) };
}

/// What is left of `vector` around the axis, of length 1.
Vec3 Around(const Vec3& axis, const Vec3& vector)
{
  return (vector - vector.dot(axis) * axis).normalized();
}
}

Vec3 SumOfNormals(const TangentPlanes& planes)
{
  Vec3 sum = Vec3::Zero();
  for (const Vec3& normal : planes.Normals)
  {
    sum += normal;
  }
  return sum;
}

ConeTip FindConeTip(const TangentPlanes& planes)
{
  Predictor predictor(planes.Points.front());
  for (std::size_t i = 0; i < planes.Points.size(); ++i)
  {
    predictor.AddPlane(planes.Points[i], planes.Normals[i], 1.0);
  }
  return TipAt(planes, predictor.Position(std::numeric_limits<double>::max()), 0.0);
}

ConeTip FindBlurredConeTip(const TangentPlanes& planes)
{
  constexpr int Steps = 4; // distances to the tip change little after the second
  const Vec3 start = FindConeTip(planes).Point;
  Vec3 tip = start;
  double blur = 0.0;
  for (int step = 0; step < Steps; ++step)
  {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < planes.Points.size(); ++i)
    {
      const Vec3& normal = planes.Normals[i];
      Eigen::Vector4d row;
      row << normal, -1.0 / (planes.Points[i] - tip).norm();
      sum += row * row.transpose();
      right += row * normal.dot(planes.Points[i] - start);
    }
    const Eigen::Vector4d solution = sum.ldlt().solve(right);
    tip = start + solution.head<3>();
    blur = solution[3];
  }
  return TipAt(planes, tip, blur);
}

Vec3 OnCone(const TangentPlanes& planes, const Vec3& tip, const Vec3& point)
{
  constexpr int Sharpness = 16; // of a cosine's power: counts what is within some twenty degrees
  constexpr double Whole = 0.5; // up to this part of the way to the planes nothing fades
  const Vec3 axis = SumOfNormals(planes).normalized();
  const Vec3 direction = Around(axis, point - tip);
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < planes.Points.size(); ++i)
  {
    const double like = std::max(0.0, direction.dot(Around(axis, planes.Points[i] - tip)));
    normal += std::pow(like, Sharpness) * planes.Normals[i];
  }
  normal.normalize();
  const double way = (point - tip).norm() / NearestTo(planes, tip);
  const double share = std::clamp((1.0 - way) / (1.0 - Whole), 0.0, 1.0);
  return point - share * normal.dot(point - tip) * normal;
}
}
