// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FirstGuess.h"

#include "LeastSquares.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace arris
{
namespace
{
/// Calls visit(point, weight) for the corners of all triangles.
template <typename Visit>
void VisitCorners(const FaceSample& face, Visit&& visit)
{
  for (const FaceSample::Item& item : face.Items)
  {
    for (const Vec3& corner : item.Corners)
    {
      visit(corner, item.Weight / 3.0);
    }
  }
}

Vec3 MeanCorner(const FaceSample& face)
{
  Vec3 mean = Vec3::Zero();
  VisitCorners(face, [&](const Vec3& point, double weight) { mean += weight * point; });
  return mean;
}

/// The direction in which a symmetric matrix is least.
Vec3 LeastDirection(const Eigen::Matrix3d& matrix)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvectors().col(0);
}

/// Solves the weighted least squares problem row . x = value, given row by row.
template <int Size>
class LinearFit
{
public:
  using Row = Eigen::Matrix<double, Size, 1>;

  void Add(const Row& row, double value, double weight)
  {
    this->Matrix += weight * row * row.transpose();
    this->Right += weight * value * row;
  }
  Row Solve() const { return SolveLeastSquares(this->Matrix, this->Right); }

private:
  Eigen::Matrix<double, Size, Size> Matrix = Eigen::Matrix<double, Size, Size>::Zero();
  Row Right = Row::Zero();
};

struct Circle
{
  Eigen::Vector2d Centre;
  double Radius = 0.0; ///< not positive if there is none
};

/// The circle through points in a plane.
template <typename Project>
Circle FitCircle(const FaceSample& face, Project&& project)
{
  LinearFit<3> fit;
  VisitCorners(face,
    [&](const Vec3& point, double weight)
    {
      const Eigen::Vector2d p = project(point);
      fit.Add({ 2.0 * p.x(), 2.0 * p.y(), 1.0 }, p.squaredNorm(), weight);
    });
  const Vec3 x = fit.Solve();
  const double radius2 = x.z() + x.head<2>().squaredNorm();
  return { x.head<2>(), radius2 > 0.0 ? std::sqrt(radius2) : 0.0 };
}

/// The axis that the normals' lines meet; whether there is one.
bool FindAxis(const FaceSample& face, const Vec3& origin, Primitive& shape)
{
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  Matrix6 products = Matrix6::Zero();
  for (const FaceSample::Item& item : face.Items)
  {
    Eigen::Matrix<double, 6, 1> line; // times (direction, moment) of a line it meets: 0
    line << (item.Centroid - origin).cross(item.Normal), item.Normal;
    products += item.Weight * line * line.transpose();
  }
  // The least of it for a direction of length 1: the best moment for each direction first.
  const Eigen::Matrix3d moments = products.bottomRightCorner<3, 3>();
  const Eigen::Matrix3d mixed = products.topRightCorner<3, 3>();
  const Eigen::Matrix3d toMoment = -SolveLeastSquares(moments, mixed.transpose());
  shape.Axis = LeastDirection(products.topLeftCorner<3, 3>() + mixed * toMoment);
  const Vec3 moment = toMoment * shape.Axis;
  shape.Point = origin + shape.Axis.cross(moment); // the axis' nearest point to the origin
  return shape.Point.allFinite();
}
}

bool GuessPlane(const FaceSample& face, Primitive& shape)
{
  shape = Primitive();
  shape.Kind = PrimitiveKind::Plane;
  shape.Point = MeanCorner(face);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Vec3 normal = Vec3::Zero();
  VisitCorners(face,
    [&](const Vec3& point, double weight)
    { spread += weight * (point - shape.Point) * (point - shape.Point).transpose(); });
  for (const FaceSample::Item& item : face.Items)
  {
    normal += item.Weight * item.Normal;
  }
  shape.Axis = LeastDirection(spread);
  shape.Axis *= shape.Axis.dot(normal) < 0.0 ? -1.0 : 1.0; // outwards
  return true;
}

bool GuessSphere(const FaceSample& face, Primitive& shape)
{
  shape = Primitive();
  shape.Kind = PrimitiveKind::Sphere;
  const Vec3 origin = MeanCorner(face);
  LinearFit<4> fit;
  VisitCorners(face,
    [&](const Vec3& point, double weight)
    {
      const Vec3 p = point - origin;
      fit.Add({ 2.0 * p.x(), 2.0 * p.y(), 2.0 * p.z(), 1.0 }, p.squaredNorm(), weight);
    });
  const Eigen::Vector4d x = fit.Solve();
  const double radius2 = x.w() + x.head<3>().squaredNorm();
  shape.Point = origin + x.head<3>();
  shape.Radius = radius2 > 0.0 ? std::sqrt(radius2) : 0.0;
  return shape.Radius > 0.0;
}

bool GuessCylinder(const FaceSample& face, Primitive& shape)
{
  shape = Primitive();
  shape.Kind = PrimitiveKind::Cylinder;
  const Vec3 origin = MeanCorner(face);
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  for (const FaceSample::Item& item : face.Items)
  {
    normals += item.Weight * item.Normal * item.Normal.transpose();
  }
  shape.Axis = LeastDirection(normals);
  const Vec3 u = shape.Axis.unitOrthogonal();
  const Vec3 v = shape.Axis.cross(u);
  const Circle circle = FitCircle(face,
    [&](const Vec3& point)
    { return Eigen::Vector2d((point - origin).dot(u), (point - origin).dot(v)); });
  shape.Point = origin + circle.Centre.x() * u + circle.Centre.y() * v;
  shape.Radius = circle.Radius;
  return shape.Radius > 0.0;
}

bool GuessCone(const FaceSample& face, Primitive& shape)
{
  shape = Primitive();
  shape.Kind = PrimitiveKind::Cone;
  const Vec3 origin = MeanCorner(face);
  Vec3 mean = Vec3::Zero();
  for (const FaceSample::Item& item : face.Items)
  {
    mean += item.Weight * item.Normal;
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  LinearFit<3> apex;
  for (const FaceSample::Item& item : face.Items)
  {
    spread += item.Weight * (item.Normal - mean) * (item.Normal - mean).transpose();
    apex.Add(item.Normal, item.Normal.dot(item.Centroid - origin), item.Weight);
  }
  shape.Point = origin + apex.Solve();
  shape.Axis = LeastDirection(spread);
  shape.Axis *= shape.Axis.dot(origin - shape.Point) < 0.0 ? -1.0 : 1.0;
  VisitCorners(face,
    [&](const Vec3& point, double weight)
    {
      const Vec3 from = point - shape.Point;
      shape.HalfAngle += weight * std::atan2(from.cross(shape.Axis).norm(), from.dot(shape.Axis));
    });
  return shape.Point.allFinite();
}

bool GuessTorus(const FaceSample& face, Primitive& shape)
{
  shape = Primitive();
  shape.Kind = PrimitiveKind::Torus;
  if (!FindAxis(face, MeanCorner(face), shape))
  {
    return false;
  }
  const Circle circle = FitCircle(face,
    [&](const Vec3& point)
    {
      const Vec3 from = point - shape.Point;
      return Eigen::Vector2d(from.cross(shape.Axis).norm(), from.dot(shape.Axis));
    });
  shape.Point += circle.Centre.y() * shape.Axis;
  shape.Radius = std::abs(circle.Centre.x());
  shape.MinorRadius = circle.Radius;
  return shape.MinorRadius > 0.0;
}
}
