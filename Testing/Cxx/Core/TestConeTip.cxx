// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/ConeTip.h"

#include "Core/Geometry.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace arris;

namespace
{
const Vec3 Tip(1.0, -2.0, 3.0);
constexpr double HalfAngle = 30.0 * Pi / 180.0;
constexpr int Sectors = 20;

Vec3 Along(double turn)
{
  return { std::sin(HalfAngle) * std::cos(turn), std::sin(HalfAngle) * std::sin(turn),
    -std::cos(HalfAngle) };
}

Vec3 NormalAt(double turn)
{
  return { std::cos(HalfAngle) * std::cos(turn), std::cos(HalfAngle) * std::sin(turn),
    std::sin(HalfAngle) };
}

/// The planes of a cone, 4 to 8 from its tip, which pass the tip at `blur` over that.
TangentPlanes ConeOf(double blur)
{
  TangentPlanes planes;
  for (int i = 0; i < Sectors; ++i)
  {
    const double turn = 2.0 * Pi * i / Sectors;
    for (double s = 4.0; s <= 8.0; ++s)
    {
      planes.Normals.push_back(NormalAt(turn));
      planes.Points.emplace_back(Tip + s * Along(turn) - blur / s * NormalAt(turn));
    }
  }
  return planes;
}
}

TEST(ConeTip, IsWhereThePlanesMeet)
{
  const ConeTip tip = FindConeTip(ConeOf(0.0));
  EXPECT_LT((tip.Point - Tip).norm(), 1e-9);
  EXPECT_LT(tip.Misfit, 1e-9);
  EXPECT_EQ(tip.Blur, 0.0);
}

TEST(ConeTip, IsWhereThePlanesMetBeforeABlur)
{
  constexpr double Blur = 1.0; // of 0.8 in width: 0.8^2 / tan(30 degrees)
  const TangentPlanes planes = ConeOf(Blur);
  EXPECT_GT((FindConeTip(planes).Point - Tip).norm(), 0.25);
  const ConeTip tip = FindBlurredConeTip(planes);
  EXPECT_LT((tip.Point - Tip).norm(), 0.01);
  EXPECT_LT(tip.Misfit, 0.001);
  EXPECT_NEAR(tip.Blur, Blur / 4.0, 0.01);
}

TEST(ConeTip, TakesWhatIsNearOntoTheCone)
{
  const TangentPlanes planes = ConeOf(0.0);
  const Vec3 place = Tip + 1.5 * Along(0.3);
  EXPECT_LT((OnCone(planes, Tip, place - 0.4 * NormalAt(0.3)) - place).norm(), 0.02);
}

TEST(ConeTip, LeavesWhatIsAsFarAsThePlanes)
{
  const Vec3 point = Tip + 4.0 * Along(0.3) - 0.1 * NormalAt(0.3);
  EXPECT_EQ(OnCone(ConeOf(0.0), Tip, point), point);
}
