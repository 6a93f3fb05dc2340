// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Straighten.h"

#include "Core/Geometry.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 4;
constexpr Index Rows = 8;
constexpr double Angle = 90.0;

Index OnRidge(Index row)
{
  return row * (2 * Width + 1) + Width;
}

/// A roof whose ridge has been cut off but at its ends, and knows the two faces beside it.
class DamagedRoof : public ::testing::Test
{
protected:
  DamagedRoof()
  {
    const Sheet left(Vec3::Zero(), this->NormalOf(OnRidge(0) - 1));
    const Sheet right(Vec3::Zero(), this->NormalOf(OnRidge(0) + 1));
    this->Labels.Labels.assign(this->Roof.Points.size(), 0);
    this->Labels.SidesOf.assign(this->Roof.Points.size(), NoIndex);
    this->Labels.FirstApexLabel = 2;
    for (Index row = 1; row < Rows; ++row)
    {
      this->Labels.SidesOf[OnRidge(row)] = static_cast<Index>(this->Labels.Sides.size());
      this->Labels.Sides.push_back({ { 0, left, 1.0, 0.0 }, { 1, right, 1.0, 0.0 } });
      this->Damaged.push_back(OnRidge(row));
      this->Cut.Points[OnRidge(row)].z() -= 0.3;
    }
  }

  Vec3 NormalOf(Index vertex) const
  {
    const Index t = this->Around.TrianglesOfVertex[vertex][0];
    return arris::Corners(this->Roof, t).AreaVector().normalized();
  }

  /// Where the ridge's vertices are after they were at `points`.
  std::vector<Vec3> Straightened(const std::vector<Vec3>& points) const
  {
    Placement placement(this->Cut, this->Around, this->Labels, this->Scales,
      std::vector<Index>(this->Roof.Triangles.size(), 0));
    for (Index v : this->Damaged)
    {
      placement.SetPoint(v, points[v]);
    }
    Straighten(this->Cut, this->Around, this->Labels, this->Cut.Points, this->Damaged, placement);
    return placement.AllPoints();
  }

  const Mesh Roof = Fold(Width, Rows, Angle);
  Mesh Cut = this->Roof;
  const Connectivity Around = Connectivity(this->Roof);
  const std::vector<double> Scales = std::vector<double>(this->Roof.Points.size(), 1.0);
  Labelling Labels;
  std::vector<Index> Damaged;
};
}

TEST_F(DamagedRoof, GetsItsNotchesFilled)
{
  std::vector<Vec3> notched = this->Roof.Points;
  notched[OnRidge(3)] = this->Cut.Points[OnRidge(3)];
  notched[OnRidge(6)] += Vec3(0.2, 0.0, -0.2); // on one of the faces
  const std::vector<Vec3> after = this->Straightened(notched);
  for (std::size_t v = 0; v < after.size(); ++v)
  {
    EXPECT_LT((after[v] - this->Roof.Points[v]).norm(), 1e-9) << "vertex " << v;
  }
}

TEST_F(DamagedRoof, StaysToTheBitWhereItIsStraight)
{
  EXPECT_EQ(this->Straightened(this->Roof.Points), this->Roof.Points);
}
