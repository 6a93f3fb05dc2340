// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Refine.h"

#include "LeastSquares.h"

#include <Eigen/Geometry>

#include <cmath>

namespace arris
{
namespace
{
constexpr int MostParameters = 7;
constexpr int MostSteps = 25; // five to ten are usual
constexpr double Converged =
  1e-9; // a step that makes the sum fall by less, relatively, is the last
constexpr double DifferenceStep = 1e-6; // of a parameter, for derivatives: about the root of what
                                        // double precision resolves

/// What can change about a shape: along two directions across its axis and along it, the axis'
/// direction across both, and its radii and angle.
enum Parameter
{
  AlongU,
  AlongV,
  AlongAxis,
  TiltU,
  TiltV,
  Radius,
  MinorRadius,
  HalfAngle
};

std::vector<Parameter> ParametersOf(PrimitiveKind kind)
{
  switch (kind)
  {
    case PrimitiveKind::Sphere:
      return { AlongU, AlongV, AlongAxis, Radius };
    case PrimitiveKind::Cylinder:
      return { AlongU, AlongV, TiltU, TiltV, Radius };
    case PrimitiveKind::Cone:
      return { AlongU, AlongV, AlongAxis, TiltU, TiltV, HalfAngle };
    case PrimitiveKind::Torus:
      return { AlongU, AlongV, AlongAxis, TiltU, TiltV, Radius, MinorRadius };
    default:
      return {}; // a plane is found in closed form
  }
}

/// Changes one parameter, lengths as parts of `size`.
void Change(Primitive& shape, const Vec3& u, const Vec3& v, Parameter what, double by, double size)
{
  switch (what)
  {
    case AlongU:
      shape.Point += by * size * u;
      break;
    case AlongV:
      shape.Point += by * size * v;
      break;
    case AlongAxis:
      shape.Point += by * size * u.cross(v);
      break;
    case TiltU:
      shape.Axis = (shape.Axis + by * u).normalized();
      break;
    case TiltV:
      shape.Axis = (shape.Axis + by * v).normalized();
      break;
    case Radius:
      shape.Radius += by * size;
      break;
    case MinorRadius:
      shape.MinorRadius += by * size;
      break;
    case HalfAngle:
      shape.HalfAngle += by;
      break;
  }
}

/// Distances of all corners, as parts of `size`, times the roots of their weights.
Eigen::VectorXd Residuals(const FaceSample& face, const Primitive& shape, double size)
{
  Eigen::VectorXd residuals(3 * static_cast<Eigen::Index>(face.Items.size()));
  Eigen::Index row = 0;
  for (const FaceSample::Item& item : face.Items)
  {
    const double weight = std::sqrt(item.Weight / 3.0) / size;
    for (const Vec3& corner : item.Corners)
    {
      residuals[row++] = weight * shape.Distance(corner);
    }
  }
  return residuals;
}
}

void Refine(const FaceSample& face, double size, Primitive& shape)
{
  const std::vector<Parameter> parameters = ParametersOf(shape.Kind);
  const auto count = static_cast<Eigen::Index>(parameters.size());
  Eigen::VectorXd residuals = Residuals(face, shape, size);
  double damping = 1e-3; // the usual start; it adapts
  for (int step = 0; count > 0 && step < MostSteps; ++step)
  {
    const bool hasAxis = shape.Kind != PrimitiveKind::Sphere;
    const Vec3 axis = hasAxis ? shape.Axis : Vec3(Vec3::UnitZ());
    const Vec3 u = axis.unitOrthogonal();
    const Vec3 v = axis.cross(u);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Eigen::Dynamic, MostParameters>
      jacobian(residuals.size(), count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      Primitive changed = shape;
      Change(changed, u, v, parameters[i], DifferenceStep, size);
      jacobian.col(i) = (Residuals(face, changed, size) - residuals) / DifferenceStep;
    }
    const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
    const Eigen::VectorXd gradient = jacobian.transpose() * residuals;
    Eigen::MatrixXd damped = normal;
    damped.diagonal() *= 1.0 + damping;
    const Eigen::VectorXd change = SolveLeastSquares(damped, -gradient);
    Primitive next = shape;
    for (Eigen::Index i = 0; i < count; ++i)
    {
      Change(next, u, v, parameters[i], change[i], size);
    }
    const Eigen::VectorXd after = Residuals(face, next, size);
    const double gain = residuals.squaredNorm() - after.squaredNorm();
    if (gain > 0.0)
    {
      const bool last = gain <= Converged * residuals.squaredNorm();
      shape = next;
      residuals = after;
      damping *= 0.1;
      if (last)
      {
        return;
      }
    }
    else
    {
      damping *= 10.0;
      if (!(damping < 1e8))
      {
        return;
      }
    }
  }
}
}
