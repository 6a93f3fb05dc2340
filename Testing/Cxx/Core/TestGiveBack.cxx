// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/GiveBack.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 6;
constexpr Index Rows = 8;
constexpr double Angle = 90.0;

/// A fold that was cut off, its column of cut vertices the damaged ones, and their placement.
class CutFold : public ::testing::Test
{
protected:
  CutFold()
  {
    this->Damaged.SidesOf.assign(this->Cut.Points.size(), NoIndex);
    for (std::size_t v = 0; v < this->Region.size(); ++v)
    {
      if (this->Cut.Points[v] != this->Whole.Points[v])
      {
        this->Region[v] = 1;
        this->Damaged.SidesOf[v] = static_cast<Index>(this->Damaged.Sides.size());
        this->Damaged.Sides.emplace_back();
      }
    }
  }

  /// What is left of a recovery that has put the damaged vertices there.
  std::vector<Vec3> Left(const std::vector<Vec3>& recovered, bool tip)
  {
    const std::vector<double> scales(this->Cut.Points.size(), 1.0);
    Placement placement(this->Cut, this->Around, this->Damaged, scales,
      std::vector<Index>(this->Cut.Triangles.size(), NoIndex));
    for (std::size_t v = 0; v < this->Region.size(); ++v)
    {
      if (this->Region[v] && tip)
      {
        placement.Pin(static_cast<Index>(v), recovered[v]);
      }
      else if (this->Region[v])
      {
        placement.SetPoint(static_cast<Index>(v), recovered[v]);
      }
    }
    GiveBackTheMoreCreased(this->Cut, this->Around, this->Region, this->Cut.Points, placement);
    return placement.AllPoints();
  }

  const Mesh Whole = Fold(Width, Rows, Angle);
  const Mesh Cut = ChamferedFold(Width, Rows, Angle, 0.5);
  const Connectivity Around = Connectivity(Cut);
  Flags Region = Flags(Cut.Points.size(), 0);
  Labelling Damaged;
};

/// The whole fold with every other vertex of its edge raised to a spike.
std::vector<Vec3> Spikes(const Mesh& whole, const Flags& region)
{
  std::vector<Vec3> points = whole.Points;
  bool odd = false;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    if (region[v])
    {
      points[v].z() += odd ? 1.0 : -1.0;
      odd = !odd;
    }
  }
  return points;
}
}

TEST_F(CutFold, StaysRecoveredWhereThatLeavesFewerCreases)
{
  EXPECT_EQ(this->Left(this->Whole.Points, false), this->Whole.Points);
}

TEST_F(CutFold, IsGivenBackWhereSpikesWereMadeOfIt)
{
  EXPECT_EQ(this->Left(Spikes(this->Whole, this->Region), false), this->Cut.Points);
}

TEST_F(CutFold, StaysAsItIsWithATip)
{
  const std::vector<Vec3> spikes = Spikes(this->Whole, this->Region);
  EXPECT_EQ(this->Left(spikes, true), spikes);
}
