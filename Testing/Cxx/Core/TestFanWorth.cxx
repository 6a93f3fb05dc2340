// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/FanWorth.h"

#include "Meshes.h"

#include <gtest/gtest.h>

#include <random>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 6;
constexpr Index Middle = MiddleOfGrid(Width);

/// A flat grid, of which nothing is damaged: triangles are to face as they did.
class FlatFan : public ::testing::Test
{
protected:
  FlatFan() { this->Labels.SidesOf.assign(this->Before.Points.size(), NoIndex); }

  Placement Unmoved() const
  {
    return Placement(this->Before, this->Around, this->Labels, this->Scales,
      std::vector<Index>(this->Before.Triangles.size(), NoIndex));
  }

  double Plain(const Placement& placement) const
  {
    return WorthOf(this->Before, this->Around, placement, this->Around.TrianglesOfVertex[Middle]);
  }

  const Mesh Before = FlatGrid(Width, Width);
  const Connectivity Around = Connectivity(Before);
  Labelling Labels;
  const std::vector<double> Scales = std::vector<double>(Before.Points.size(), 1.0);
};
}

TEST_F(FlatFan, IsWorthMostWhereAllIsGoodEnough)
{
  const Placement placement = this->Unmoved();
  EXPECT_DOUBLE_EQ(this->Plain(placement), MostWorth(6));
}

TEST_F(FlatFan, IsWorthLessByOneForEachTriangleTurnedOver)
{
  Placement placement = this->Unmoved();
  // Beyond its right neighbour: the two triangles on that side lie on what is next to them.
  placement.SetPoint(Middle, this->Before.Points[Middle] + Vec3(1.4, 0.1, 0.0));
  EXPECT_LT(this->Plain(placement), MostWorth(6) - 1.0);
}

TEST_F(FlatFan, IsWorthTheSameTriedAgainAndAgain)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-1.5, 1.5);
  Placement placement = this->Unmoved();
  for (const Index n : this->Around.NeighborsOfVertex[Middle])
  {
    placement.SetPoint(n, this->Before.Points[n] + 0.3 * Vec3(offset(random), offset(random), 0.0));
  }
  FanWorth fan(this->Before, this->Around, placement);
  fan.Take(Middle);
  int turnedOver = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Vec3 move(offset(random), offset(random), 0.2 * offset(random));
    placement.SetPoint(Middle, this->Before.Points[Middle] + move);
    const double plain = this->Plain(placement);
    EXPECT_EQ(fan.Now(), plain);
    EXPECT_EQ(fan.Now(plain - 0.5), plain);
    EXPECT_LE(fan.Now(plain + 0.5), plain + 0.5);
    turnedOver += plain < -1.0 ? 1 : 0;
  }
  EXPECT_GT(turnedOver, 20);
  EXPECT_LT(turnedOver, 180);
}
