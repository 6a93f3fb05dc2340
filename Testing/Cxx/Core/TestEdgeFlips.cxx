// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/EdgeFlips.h"

#include <gtest/gtest.h>

using namespace arris;

namespace
{
/// A square fan of one face, all damaged but for its rim: the triangles of the edge (0, 1) have
/// little area once vertex 2 has been put next to it.
class PoorEdge : public ::testing::Test
{
protected:
  PoorEdge()
  {
    this->Before.Points = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { -3, 0, 0 },
      { 3, 0, 0 }, { 0, 3, 0 }, { 0, -3, 0 } };
    this->Before.Triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 2, 6 }, { 2, 1, 6 }, { 0, 7, 3 },
      { 3, 7, 1 }, { 0, 6, 4 }, { 6, 1, 5 }, { 0, 4, 7 }, { 1, 7, 5 } };
    this->Around = Connectivity(this->Before);
    this->Labels.SidesOf.assign(this->Before.Points.size(), NoIndex);
    this->Labels.Labels.assign(this->Before.Points.size(), NoIndex);
    for (const Index v : { 0, 1, 2, 3 })
    {
      this->Labels.SidesOf[v] = static_cast<Index>(this->Labels.Sides.size());
      this->Labels.Sides.push_back({ { 0, Sheet(Vec3::Zero(), Vec3::UnitZ()), 1.0, 0.0 } });
    }
  }

  Index Flip(const Vec3& second)
  {
    Placement placement(this->Before, this->Around, this->Labels, this->Scales, this->FaceLabels);
    for (const Index v : { 0, 1, 2, 3 })
    {
      placement.Place(v);
    }
    placement.SetPoint(2, second);
    return FlipEdges(this->Before, this->Around, placement);
  }

  Mesh Before;
  Connectivity Around;
  Labelling Labels;
  std::vector<double> Scales = std::vector<double>(8, 1.0);
  std::vector<Index> FaceLabels = std::vector<Index>(10, 0);
};
}

TEST_F(PoorEdge, IsFlipped)
{
  EXPECT_EQ(this->Flip({ 0, 0.001, 0 }), 1);
  const std::vector<Triangle>& triangles = this->Before.Triangles;
  EXPECT_EQ(triangles[0], (Triangle{ 2, 0, 3 }));
  EXPECT_EQ(triangles[1], (Triangle{ 3, 1, 2 }));
  const Connectivity anew(this->Before);
  EXPECT_EQ(this->Around.AcrossEdge, anew.AcrossEdge);
  EXPECT_EQ(this->Around.OnBoundary, anew.OnBoundary);
  EXPECT_EQ(this->Around.TrianglesOfVertex.Values, anew.TrianglesOfVertex.Values);
}

TEST_F(PoorEdge, StaysBesideAGoodTriangle)
{
  EXPECT_EQ(this->Flip({ 0, 1, 0 }), 0);
}

TEST_F(PoorEdge, StaysBetweenTwoFaces)
{
  this->FaceLabels[1] = 1;
  EXPECT_EQ(this->Flip({ 0, 0.001, 0 }), 0);
}

TEST_F(PoorEdge, StaysWhereAVertexIsIntact)
{
  this->Labels.SidesOf[3] = NoIndex;
  Placement placement(this->Before, this->Around, this->Labels, this->Scales, this->FaceLabels);
  placement.SetPoint(2, { 0, 0.001, 0 });
  EXPECT_EQ(FlipEdges(this->Before, this->Around, placement), 0);
}

TEST_F(PoorEdge, StaysWhereTheNewOneWouldFoldIfAllWereGivenBack)
{
  // Turning to (2, 3) folds the unmoved square, whose corner 0 lies right of that line.
  this->Before.Points[0] = { 0.2, 0, 0 };
  EXPECT_EQ(this->Flip({ 0.3, 0.001, 0 }), 0);
}
