// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Ears.h"

#include <gtest/gtest.h>

using namespace arris;

namespace
{
/// A plane of two patches that meet along the x axis at y = 0, and a third that stands on it there.
/// Of the upper one, the triangle (0, 1, 2) has all its corners on the axis.
class EarOnAJunction : public ::testing::Test
{
protected:
  EarOnAJunction()
  {
    this->Before.Points = { { -1, 0, 0 }, { 0.1, -0.3, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
      { 0, 0, 1 } };
    this->Before.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 4, 1 }, { 1, 4, 2 }, { 0, 1, 5 },
      { 1, 2, 5 } };
    this->Around = Connectivity(this->Before);
    this->Around.PatchOf = { 0, 0, 1, 1, 2, 2 };
    this->Around.Common = { 1, 1, 1, 0, 0, 0 };
    this->Labels.SidesOf.assign(this->Before.Points.size(), NoIndex);
    this->Labels.Labels.assign(this->Before.Points.size(), NoIndex);
    for (const Index v : { 0, 1, 2 })
    {
      this->Labels.SidesOf[v] = static_cast<Index>(this->Labels.Sides.size());
      const Sheet floor(Vec3::Zero(), Vec3::UnitZ());
      const Sheet wall(Vec3::Zero(), -Vec3::UnitY());
      this->Labels.Sides.push_back(
        { { 0, floor, 1.0, 0.0 }, { 1, floor, 1.0, 0.0 }, { 2, wall, 1.0, 0.0 } });
    }
  }

  Mesh Before;
  Connectivity Around;
  Labelling Labels;
  std::vector<double> Scales = std::vector<double>(6, 1.0);
};
}

TEST_F(EarOnAJunction, IsGivenAreaInItsFace)
{
  Placement placement(this->Before, this->Around, this->Labels, this->Scales, this->Around.PatchOf);
  for (const Index v : { 0, 1, 2 })
  {
    placement.Place(v);
  }
  ASSERT_LT(placement.PointOf(1).tail<2>().norm(), 1e-9) << "or it is not on the junction";
  ASSERT_LT(placement.Quality(0), 1e-6);
  LiftEars(this->Before, this->Around, this->Scales, placement);
  EXPECT_GT(placement.Quality(0), 0.005);
  EXPECT_LT(placement.PointOf(1).y(), 0.0);
  EXPECT_GT(placement.PointOf(1).y(), -0.05);
  EXPECT_NEAR(placement.PointOf(1).z(), 0.0, 1e-9);
}

TEST_F(EarOnAJunction, StaysFlatWhereItCameSo)
{
  this->Before.Points[1].y() = 0.0;
  Placement placement(this->Before, this->Around, this->Labels, this->Scales, this->Around.PatchOf);
  for (const Index v : { 0, 1, 2 })
  {
    placement.Place(v);
  }
  LiftEars(this->Before, this->Around, this->Scales, placement);
  EXPECT_EQ(placement.AllPoints(), this->Before.Points);
}
