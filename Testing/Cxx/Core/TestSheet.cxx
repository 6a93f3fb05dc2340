// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Sheet.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace arris;

namespace
{
constexpr double Scale = 2.0; // any: a sheet must not depend on the unit of length
const SheetCaution Caution;

/// Samples of the surface over a square beside the origin: a sheet is asked about where it has
/// none.
template <typename Surface>
std::vector<SheetSample> SamplesBeside(const Surface& surface)
{
  std::vector<SheetSample> samples;
  for (double u = 1.0; u <= 5.0; u += 0.5)
  {
    for (double w = -2.0; w <= 2.0; w += 0.5)
    {
      samples.push_back({ surface(Scale * u, Scale * w), Vec3::UnitZ(), 1.0 });
    }
  }
  return samples;
}

Vec3 OnPlane(double u, double w)
{
  return { u, w, 0.3 * u - 0.2 * w };
}

Vec3 OnCylinder(double u, double w)
{
  const double radius = 6.0 * Scale;
  return { radius * std::sin(u / radius), w, radius * std::cos(u / radius) - radius };
}

Vec3 OnSphere(double u, double w)
{
  const double radius = 8.0 * Scale;
  return { u, w, std::sqrt(radius * radius - u * u - w * w) - radius };
}
}

TEST(Sheet, OfAPlaneIsThePlane)
{
  const Sheet sheet(SamplesBeside(OnPlane), Scale, Caution);
  const Vec3 far(-10.0, 7.0, 0.0);
  const Vec3 normal = Vec3(-0.3, 0.2, 1.0).normalized();
  EXPECT_NEAR(sheet.Distance(far), far.dot(normal), 1e-9);
  EXPECT_NEAR((sheet.Normal(far) - normal).norm(), 0.0, 1e-9);
}

TEST(Sheet, OneOutlierDoesNotTiltAPlane)
{
  std::vector<SheetSample> samples = SamplesBeside(OnPlane);
  samples[3].Position[2] += 0.4 * Scale;
  const Vec3 off = OnPlane(-4.0, 0.0);
  EXPECT_NEAR(Sheet(samples, Scale, Caution).Distance(off), 0.0, 1e-6 * Scale);
}

TEST(Sheet, GoesOnAsACylinderWhereItHasNoSamples)
{
  const Sheet sheet(SamplesBeside(OnCylinder), Scale, Caution);
  for (const double u : { 0.0, -1.0, -2.0 })
  {
    const Vec3 point = OnCylinder(Scale * u, 0.7);
    EXPECT_NEAR(sheet.Distance(point), 0.0, 1e-4 * Scale) << u;
    EXPECT_NEAR(sheet.Normal(point)[0], std::sin(u / 6.0), 1e-3) << u;
  }
}

TEST(Sheet, GoesOnAsASphereWhereItHasNoSamples)
{
  const Sheet sheet(SamplesBeside(OnSphere), Scale, Caution);
  for (const double u : { 0.0, -1.0, -2.0 })
  {
    EXPECT_NEAR(sheet.Distance(OnSphere(Scale * u, 0.5)), 0.0, 1e-4 * Scale) << u;
  }
}

TEST(Sheet, DistanceIsPositiveOutside)
{
  const Sheet sheet(SamplesBeside(OnSphere), Scale, Caution);
  EXPECT_NEAR(sheet.Distance(OnSphere(0.0, 0.0) + Vec3(0.0, 0.0, 0.5)), 0.5, 1e-3);
  EXPECT_NEAR(sheet.Distance(OnSphere(0.0, 0.0) - Vec3(0.0, 0.0, 0.5)), -0.5, 1e-3);
}

TEST(Sheet, OfOneSampleIsItsTangentPlane)
{
  const Sheet sheet({ { Vec3(1.0, 2.0, 3.0), Vec3::UnitX(), 1.0 } }, Scale, Caution);
  EXPECT_DOUBLE_EQ(sheet.Distance(Vec3(4.0, 0.0, 0.0)), 3.0);
}

// It takes all others for outliers, and a plane through one point would turn with its rounding.
TEST(Sheet, OfASampleThatOutweighsAllOthersIsNotTurnedByRounding)
{
  const Vec3 heavy(0.1, 0.7, 0.3), normal(0.48, 0.6, 0.64);
  const auto sheetOf = [&](double bump)
  {
    std::vector<SheetSample> samples{ { heavy, normal, 0.3 } };
    for (int k = 0; k < 4; ++k)
    {
      const Vec3 other(0.2 * k + bump * k * k, 1.0 + k * k, 0.5 * k - 1.0 - bump * k);
      samples.push_back({ other, Vec3(1.0, 0.3 * k, 0.2).normalized(), 0.03 });
    }
    return Sheet(samples, Scale, Caution);
  };
  const Vec3 away(3.0, -2.0, 1.0);
  EXPECT_NEAR(sheetOf(0.0).Distance(away), sheetOf(1e-12).Distance(away), 1e-9);
}

TEST(Sheet, OfABlurredSphereGoesBackToTheSphere)
{
  Sheet sheet(SamplesBeside(OnSphere), Scale, Caution);
  const double width = 0.5 * Scale;
  sheet.Unblur(width);
  // The mean of the distance from a sphere is greater by half the squared width times 2 / radius:
  // it is zero that much inside.
  const double blurred = 8.0 * Scale;
  const double radius = 0.5 * (blurred + std::sqrt(blurred * blurred + 4.0 * width * width));
  for (const double u : { 0.0, -2.0 })
  {
    EXPECT_NEAR(sheet.Distance(OnSphere(Scale * u, 0.5)), blurred - radius, 1e-4 * Scale) << u;
  }
}
