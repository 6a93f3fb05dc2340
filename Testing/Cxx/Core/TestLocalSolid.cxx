// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Geometry.h"
#include "Core/Robust/LocalSolid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace arris;

namespace
{
/// Samples of a square beside the z axis, in the half plane that `along` points into.
std::vector<SheetSample> HalfPlane(const Vec3& along, const Vec3& normal)
{
  std::vector<SheetSample> samples;
  for (double u = 1.0; u <= 4.0; u += 1.0)
  {
    for (double w = -2.0; w <= 2.0; w += 1.0)
    {
      samples.push_back({ u * along + w * Vec3::UnitZ(), normal, 1.0 });
    }
  }
  return samples;
}

/// Two faces that meet at the z axis, one in the half plane y = 0, x < 0 facing along y.
LocalSolid Wedge(const Vec3& along, const Vec3& normal)
{
  LocalSolid solid;
  for (const auto& samples : { HalfPlane(-Vec3::UnitX(), Vec3::UnitY()), HalfPlane(along, normal) })
  {
    solid.AddSheet(Sheet(samples, 1.0, SheetCaution()), samples);
  }
  return solid;
}

LocalSolid Convex()
{
  return Wedge(-Vec3::UnitY(), Vec3::UnitX());
}

LocalSolid Concave()
{
  return Wedge(Vec3::UnitY(), -Vec3::UnitX());
}

/// The mean of the solid's distance under a Gaussian about a point, by brute force across the edge.
double MeanDistance(const LocalSolid& solid, const Vec3& point, double width)
{
  double sum = 0.0, weights = 0.0;
  constexpr double Step = 0.05;
  for (double u = -5.0; u <= 5.0; u += Step)
  {
    for (double w = -5.0; w <= 5.0; w += Step)
    {
      const double weight = std::exp(-0.5 * (u * u + w * w));
      sum += weight * solid.Distance(point + width * Vec3(u, w, 0.0));
      weights += weight;
    }
  }
  return sum / weights;
}
}

TEST(LocalSolid, BlursAnEdgeAsAGaussianDoes)
{
  constexpr double Width = 0.8;
  for (const LocalSolid& solid : { Convex(), Concave() })
  {
    for (const Vec3& point : { Vec3(0.0, 0.0, 0.0), Vec3(-0.4, -0.3, 0.5), Vec3(-1.5, 0.1, 0.0) })
    {
      // The sum is good to 1e-5 where the distance has its kink.
      EXPECT_NEAR(
        solid.BlurredValue(point, Width).Distance, MeanDistance(solid, point, Width), 1e-4);
    }
  }
}

TEST(LocalSolid, OfABlurredEdgeLiesInsideTheConvexAndOutsideTheConcave)
{
  const double edge = 0.8 * std::sqrt(2.0) / std::sqrt(2.0 * Pi); // the mean of the greater of two
  EXPECT_NEAR(Convex().BlurredValue(Vec3::Zero(), 0.8).Distance, edge, 1e-9);
  EXPECT_NEAR(Concave().BlurredValue(Vec3::Zero(), 0.8).Distance, -edge, 1e-9);
}

TEST(LocalSolid, FarFromTheEdgeABlurChangesNothing)
{
  const Vec3 far(-12.0, 0.25, 0.0);
  const LocalSolid solid = Convex();
  EXPECT_EQ(solid.BlurredValue(far, 0.8).Distance, solid.Distance(far));
  EXPECT_NEAR((solid.SharpValue(far).Normal - Vec3::UnitY()).norm(), 0.0, 1e-9);
}
