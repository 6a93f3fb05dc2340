// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/OtherOrders.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 8;
constexpr Index Middle = MiddleOfGrid(Width);

/// A flat grid, all of it damaged and part of one face, which is flat too.
class DamagedPlane : public ::testing::Test
{
protected:
  DamagedPlane()
  {
    this->Labels.Labels.assign(this->Plane.Points.size(), 0);
    this->Labels.FirstApexLabel = 1;
    for (Index v = 0; v < this->Plane.VertexCount(); ++v)
    {
      this->Labels.SidesOf.push_back(v);
      this->Labels.Sides.push_back({ { 0, Sheet(Vec3::Zero(), Vec3::UnitZ()), 1.0, 0.0 } });
    }
  }

  Placement Placed() const
  {
    Placement placement(this->Plane, this->Around, this->Labels, this->Scales,
      std::vector<Index>(this->Plane.Triangles.size(), 0));
    for (Index v = 0; v < this->Plane.VertexCount(); ++v)
    {
      placement.Place(v);
    }
    return placement;
  }

  const Mesh Plane = FlatGrid(Width, Width);
  const Connectivity Around = Connectivity(this->Plane);
  const std::vector<double> Scales = std::vector<double>(this->Plane.Points.size(), 1.0);
  const Flags Region = Flags(this->Plane.Points.size(), 1);
  Labelling Labels;
  const Labelled All{ this->Plane, this->Plane, this->Plane, this->Around, this->Labels,
    this->Scales, this->Region };
  const Vec3 Spike = this->Plane.Points[Middle] + 0.5 * Vec3::UnitZ();
};
}

TEST_F(DamagedPlane, IsTakenFromAnOrderThatLeavesFewerCreases)
{
  const Placement placed = this->Placed();
  Placement placement = placed;
  placement.SetPoint(Middle, this->Spike);
  std::vector<Vec3> wanted = placement.AllPoints();
  TryOtherOrders(this->All, placed, { Middle }, placement, wanted);
  EXPECT_EQ(placement.AllPoints(), this->Plane.Points);
  EXPECT_EQ(wanted, this->Plane.Points);
}

TEST_F(DamagedPlane, StaysWhereNoOrderLeavesFewerCreases)
{
  Placement placed = this->Placed();
  Placement placement = placed;
  placed.SetPoint(Middle, this->Spike);
  std::vector<Vec3> wanted = placement.AllPoints();
  TryOtherOrders(this->All, placed, { Middle }, placement, wanted);
  EXPECT_EQ(placement.AllPoints(), this->Plane.Points);
}

TEST_F(DamagedPlane, StaysWhereAnotherOrderLeavesMoreTrianglesTurnedOver)
{
  Mesh mirrored = this->Plane; // against which all of the plane is turned over
  for (Vec3& point : mirrored.Points)
  {
    point.x() = -point.x();
  }
  const Labelled all{ mirrored, this->Plane, this->Plane, this->Around, this->Labels, this->Scales,
    this->Region };
  const Placement placed = this->Placed();
  Placement placement = placed;
  const Vec3 overhanging = this->Spike + 1.5 * Vec3::UnitX();
  placement.SetPoint(Middle, overhanging);
  std::vector<Vec3> wanted = placement.AllPoints();
  TryOtherOrders(all, placed, { Middle }, placement, wanted);
  EXPECT_EQ(placement.PointOf(Middle), overhanging);
}

TEST_F(DamagedPlane, IsNotMendedAgainWhereNothingWasTangled)
{
  const Placement placed = this->Placed();
  Placement placement = placed;
  placement.SetPoint(Middle, this->Spike);
  std::vector<Vec3> wanted = placement.AllPoints();
  TryOtherOrders(this->All, placed, {}, placement, wanted);
  EXPECT_EQ(placement.PointOf(Middle), this->Spike);
}
