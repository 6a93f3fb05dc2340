// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Primitive.h"

#include <Eigen/Geometry>

#include <cmath>

namespace arris
{
namespace
{
/// A point as seen from an axis.
struct Cylindrical
{
  double Height; ///< along the axis
  double Out; ///< away from it
  Vec3 Outward; ///< unit; zero on the axis

  Cylindrical(const Primitive& shape, const Vec3& point)
    : Height((point - shape.Point).dot(shape.Axis))
  {
    const Vec3 out = point - shape.Point - this->Height * shape.Axis;
    this->Out = out.norm();
    this->Outward = this->Out > 0.0 ? Vec3(out / this->Out) : Vec3(Vec3::Zero());
  }
};
}

const char* NameOf(PrimitiveKind kind)
{
  constexpr const char* Names[] = { "plane", "sphere", "cylinder", "cone", "torus", "free-form" };
  return Names[static_cast<int>(kind)];
}

double Primitive::Distance(const Vec3& point) const
{
  if (this->Kind == PrimitiveKind::Sphere)
  {
    return (point - this->Point).norm() - this->Radius;
  }
  const Cylindrical at(*this, point);
  switch (this->Kind)
  {
    case PrimitiveKind::Plane:
      return at.Height;
    case PrimitiveKind::Cylinder:
      return at.Out - this->Radius;
    case PrimitiveKind::Cone:
      return at.Out * std::cos(this->HalfAngle) - at.Height * std::sin(this->HalfAngle);
    case PrimitiveKind::Torus:
      return std::hypot(at.Out - this->Radius, at.Height) - this->MinorRadius;
    default:
      return 0.0;
  }
}

Vec3 Primitive::Normal(const Vec3& point) const
{
  if (this->Kind == PrimitiveKind::Sphere)
  {
    return (point - this->Point).normalized();
  }
  const Cylindrical at(*this, point);
  switch (this->Kind)
  {
    case PrimitiveKind::Plane:
      return this->Axis;
    case PrimitiveKind::Cylinder:
      return at.Outward;
    case PrimitiveKind::Cone:
      return std::cos(this->HalfAngle) * at.Outward - std::sin(this->HalfAngle) * this->Axis;
    case PrimitiveKind::Torus:
      return ((at.Out - this->Radius) * at.Outward + at.Height * this->Axis).normalized();
    default:
      return Vec3::Zero();
  }
}
}
