// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/FarFromRidge.h"

#include "Meshes.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 10;
constexpr Index OnRidge = MiddleOfGrid(Width) - 4;
constexpr Index Near = OnRidge + 3;
constexpr Index Far = OnRidge + 4;

/// A plane, all of it damaged, 0.1 under the face that it belongs to.
class SunkPlane : public ::testing::Test
{
protected:
  SunkPlane()
  {
    const Sheet face(Vec3(0.0, 0.0, 0.1), Vec3::UnitZ());
    const std::size_t count = this->Plane.Points.size();
    this->Labels.Labels.assign(count, 0);
    this->Labels.FirstApexLabel = 1;
    this->Labels.Sides.assign(count, { { 0, face, 1.0, 0.0 } });
    this->Damaged.resize(count);
    std::iota(this->Damaged.begin(), this->Damaged.end(), 0);
    this->Labels.SidesOf = this->Damaged;
  }

  /// All placed, and what is far from the ridge left.
  Placement Placed(Flags settled = {}) const
  {
    Placement placement(this->Plane, this->Around, this->Labels, this->Scales,
      std::vector<Index>(this->Plane.Triangles.size(), 0));
    for (Index v : this->Damaged)
    {
      placement.Place(v);
    }
    placement.SetSettled(std::move(settled));
    Flags onRidge(this->Plane.Points.size(), 0);
    onRidge[OnRidge] = 1;
    LeaveFarFromRidge(this->Around, onRidge, this->Damaged, placement);
    return placement;
  }

  const Mesh Plane = FlatGrid(Width, Width);
  const Connectivity Around = Connectivity(this->Plane);
  const std::vector<double> Scales = std::vector<double>(this->Plane.Points.size(), 1.0);
  Labelling Labels;
  std::vector<Index> Damaged;
};
}

TEST_F(SunkPlane, StaysWhereItIsFarFromTheRidge)
{
  const Placement placement = this->Placed();
  EXPECT_NEAR(placement.PointOf(OnRidge).z(), 0.1, 1e-9);
  EXPECT_NEAR(placement.PointOf(Near).z(), 0.1, 1e-9);
  EXPECT_EQ(placement.PointOf(Far), this->Plane.Points[Far]);
}

TEST_F(SunkPlane, IsNeitherLostThereNorGivenBack)
{
  Placement placement = this->Placed();
  EXPECT_FALSE(placement.IsLost(Far));
  EXPECT_FALSE(placement.IsGivenBack(Far));
  placement.Place(Far);
  EXPECT_NEAR(placement.PointOf(Far).z(), 0.1, 1e-9) << "it may still be placed";
}

TEST_F(SunkPlane, StaysWhereAnEarlierPassHasPlacedIt)
{
  Flags settled(this->Plane.Points.size(), 0);
  settled[Far] = 1;
  EXPECT_NEAR(this->Placed(settled).PointOf(Far).z(), 0.1, 1e-9);
}
