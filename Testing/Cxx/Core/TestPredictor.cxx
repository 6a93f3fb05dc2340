// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Predictor.h"

#include "Core/Geometry.h"

#include <gtest/gtest.h>

using namespace arris;

namespace
{
constexpr double Far = 1e9;

/// Two planes through the x axis whose normals differ by an angle (degrees), seen from a point
/// at height 1 over the edge.
Predictor AboveARoof(double angle)
{
  const double half = 0.5 * angle * Pi / 180.0;
  Predictor predictor(Vec3(3.0, 0.0, 1.0));
  predictor.AddPlane(Vec3(7.0, 0.0, 0.0), Vec3(0.0, std::sin(half), std::cos(half)), 1.0);
  predictor.AddPlane(Vec3(-5.0, 0.0, 0.0), Vec3(0.0, -std::sin(half), std::cos(half)), 1.0);
  return predictor;
}

/// Roofs whose edge is at y = 2 from the centre, beside it: the shallower, the less they know it.
Vec3 BesideARoof(double angle)
{
  const double half = 0.5 * angle * Pi / 180.0;
  Predictor predictor(Vec3(0.0, 0.0, 0.0));
  for (const double side : { -1.0, 1.0 })
  {
    predictor.AddPlane(Vec3(0.0, 2.0, 0.0), Vec3(0.0, side * std::sin(half), std::cos(half)), 1.0);
  }
  return predictor.Position(Far);
}

void ExpectNear(const Vec3& actual, const Vec3& expected, double tolerance)
{
  EXPECT_LE((actual - expected).norm(), tolerance)
    << actual.transpose() << " is not " << expected.transpose();
}
}

TEST(Predictor, WithoutPlanesStaysAtTheCentre)
{
  EXPECT_EQ(Predictor(Vec3(1, 2, 3)).Position(Far), Vec3(1, 2, 3));
}

TEST(Predictor, OnePlaneDrawsTheCentreStraightOntoIt)
{
  const Vec3 normal = Vec3(1, 2, -2) / 3.0;
  Predictor predictor(Vec3(5, 5, 5));
  predictor.AddPlane(Vec3(1, 0, 0), normal, 2.5);
  const Vec3 expected = Vec3(5, 5, 5) - normal.dot(Vec3(4, 5, 5)) * normal;
  ExpectNear(predictor.Position(Far), expected, 1e-14);
}

TEST(Predictor, TwoPlanesDrawItToTheNearestPointOfTheirLine)
{
  for (const double angle : { 20.0, 60.0, 90.0, 120.0, 170.0 })
  {
    // Free along the edge: least norm keeps x. Rounding is magnified by 1 / (1 - cos angle).
    ExpectNear(AboveARoof(angle).Position(Far), Vec3(3, 0, 0), 1e-13);
  }
}

TEST(Predictor, ThreePlanesMeetInACorner)
{
  const Vec3 corner(0.25, -4.0, 7.5);
  Predictor predictor(Vec3(1, 1, 1));
  predictor.AddPlane(corner + Vec3(0, 3, 1), Vec3(1, 0, 0), 1.0);
  predictor.AddPlane(corner + Vec3(2, 0, -1), Vec3(0, 1, 0), 2.0);
  predictor.AddPlane(corner + Vec3(1, -1, 0), Vec3(1, 1, std::sqrt(2.0)) / 2.0, 3.0);
  // Not the corner: the last plane's point is off it by n.(1, -1, 0) = 0, so it is.
  ExpectNear(predictor.Position(Far), corner, 1e-12);
}

TEST(Predictor, ParallelPlanesAreAveragedByWeight)
{
  Predictor predictor(Vec3(0, 0, 10));
  predictor.AddPlane(Vec3(0, 0, 0), Vec3(0, 0, 1), 3.0);
  predictor.AddPlane(Vec3(0, 0, 4), Vec3(0, 0, 1), 1.0);
  ExpectNear(predictor.Position(Far), Vec3(0, 0, 1), 1e-13);
}

TEST(Predictor, TheSignOfANormalDoesNotMatter)
{
  Predictor up(Vec3(1, 2, 3));
  up.AddPlane(Vec3(0, 0, 0), Vec3(0, 0.6, 0.8), 1.0);
  Predictor down(Vec3(1, 2, 3));
  down.AddPlane(Vec3(0, 0, 0), Vec3(0, -0.6, -0.8), 1.0);
  EXPECT_EQ(up.Position(Far), down.Position(Far));
}

TEST(Predictor, ScalingAllWeightsChangesNothing)
{
  // The unit of area must not matter, whatever the size of the mesh.
  for (const double unit : { 1e-12, 1e12 })
  {
    Predictor predictor(Vec3(1, 1, 1));
    predictor.AddPlane(Vec3(0, 0, 0), Vec3(0, 0, 1), unit);
    predictor.AddPlane(Vec3(0, 0, 0), Vec3(0, 1, 0), unit);
    ExpectNear(predictor.Position(Far), Vec3(1, 0, 0), 1e-13);
  }
}

TEST(Predictor, NearlyEqualPlanesDoNotShootAway)
{
  // Eigenvalues 1 ± cos a: dropped below a ratio of 0.005, at tan²(a / 2), which is 8.09°.
  ExpectNear(BesideARoof(8.2), Vec3(0, 2, 0), 1e-12);
  ExpectNear(BesideARoof(8.0), Vec3(0, 0, 0), 1e-12);
}

TEST(Predictor, CutsALongTranslationButKeepsItsDirection)
{
  Predictor predictor(Vec3(1, 0, 0));
  predictor.AddPlane(Vec3(0, 3, 0), Vec3(0, 1, 0), 1.0);
  predictor.AddPlane(Vec3(0, 0, 4), Vec3(0, 0, 1), 1.0);
  ExpectNear(predictor.Position(5.0), Vec3(1, 3, 4), 1e-13);
  ExpectNear(predictor.Position(2.5), Vec3(1, 1.5, 2), 1e-13);
}
