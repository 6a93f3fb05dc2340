// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Fits/Primitive.h"

#include <gtest/gtest.h>

#include <string>

using namespace arris;

namespace
{
Primitive Shape(PrimitiveKind kind)
{
  Primitive shape;
  shape.Kind = kind;
  shape.Point = Vec3(0.3, -0.2, 0.1);
  shape.Axis = Vec3(1.0, 2.0, -2.0) / 3.0;
  shape.Radius = 2.0;
  shape.MinorRadius = 0.5;
  shape.HalfAngle = 0.4;
  return shape;
}

const Vec3 Somewhere(1.5, 0.7, -1.1);
}

class Primitives : public ::testing::TestWithParam<PrimitiveKind>
{
};

TEST_P(Primitives, DistancesGrowAlongNormals)
{
  const Primitive shape = Shape(GetParam());
  const Vec3 normal = shape.Normal(Somewhere);
  EXPECT_NEAR(normal.norm(), 1.0, 1e-12);
  constexpr double Step = 1e-5;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vec3 step = Step * Vec3::Unit(axis);
    const double slope =
      (shape.Distance(Somewhere + step) - shape.Distance(Somewhere - step)) / (2.0 * Step);
    EXPECT_NEAR(normal[axis], slope, 1e-8);
  }
}

TEST_P(Primitives, AreWhereTheirDistanceIsZero)
{
  const Primitive shape = Shape(GetParam());
  const Vec3 on = Somewhere - shape.Distance(Somewhere) * shape.Normal(Somewhere);
  EXPECT_NEAR(shape.Distance(on), 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Primitives,
  ::testing::Values(PrimitiveKind::Plane, PrimitiveKind::Sphere, PrimitiveKind::Cylinder,
    PrimitiveKind::Cone, PrimitiveKind::Torus),
  [](const auto& test) { return std::string(NameOf(test.param)); });

TEST(Primitive, OfAFreeFormAreNowhere)
{
  const Primitive shape = Shape(PrimitiveKind::FreeForm);
  EXPECT_EQ(shape.Distance(Somewhere), 0.0);
  EXPECT_EQ(shape.Normal(Somewhere), Vec3(Vec3::Zero()));
}

TEST(Primitive, HaveNoNormalOnTheAxisOfACylinder)
{
  const Primitive shape = Shape(PrimitiveKind::Cylinder);
  EXPECT_EQ(shape.Normal(shape.Point), Vec3(Vec3::Zero()));
}
