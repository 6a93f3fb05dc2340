// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Features/NearCorners.h"

#include <gtest/gtest.h>

using namespace arris;

namespace
{
/// Two corners, a way apart along x, each with two curves of so many unit edges that run off to its
/// side, apart from each other by `spread` degrees.
class TwoCorners
{
public:
  TwoCorners(double way, Index edges, double spread)
  {
    const Index a = this->Add(Vec3(0, 0, 0));
    const Index b = this->Add(Vec3(way, 0, 0));
    this->Network.Curves.push_back({ a, b });
    this->Network.Corners = { { a, 3 }, { b, 3 } };
    for (const Index corner : { a, b })
    {
      for (const double side : { -1.0, 1.0 })
      {
        const double angle = (corner == a ? 0.5 : -0.5) * spread * std::acos(-1.0) / 180.0;
        const Vec3 step(-std::sin(angle), side * std::cos(angle), 0.0);
        Curve curve = { corner };
        for (Index i = 1; i <= edges; ++i)
        {
          curve.push_back(this->Add(this->Points[corner] + i * step));
        }
        this->Network.Curves.push_back(curve);
        this->Network.Corners.push_back({ curve.back(), 1 });
      }
    }
  }

  std::size_t CurvesAfter()
  {
    MergeNearCorners(this->Points, this->Network);
    return this->Network.Curves.size();
  }

  std::vector<Vec3> Points;
  CurveNetwork Network;

private:
  Index Add(const Vec3& point)
  {
    this->Points.push_back(point);
    return static_cast<Index>(this->Points.size()) - 1;
  }
};
}

TEST(NearCorners, AreOne)
{
  TwoCorners corners(0.05, 5, 40.0);
  EXPECT_EQ(corners.CurvesAfter(), 4U);
  ASSERT_EQ(corners.Network.Corners.size(), 5U);
  EXPECT_EQ(corners.Network.Corners.front().Vertex, 0);
  EXPECT_EQ(corners.Network.Corners.front().Valence, 4);
  for (const Curve& curve : corners.Network.Curves)
  {
    EXPECT_EQ(curve.front(), 0) << "all end there";
    EXPECT_NEAR(LengthOf(curve, corners.Points), curve[1] == 1 ? 5.05 : 5.0, 1e-12);
  }
}

TEST(NearCorners, AreTwoFartherApart)
{
  EXPECT_EQ(TwoCorners(0.15, 5, 40.0).CurvesAfter(), 5U);
}

TEST(NearCorners, AreTwoWhereCurvesRunAlikeAsAlongAThinPlate)
{
  EXPECT_EQ(TwoCorners(0.05, 5, 0.0).CurvesAfter(), 5U);
}

TEST(NearCorners, AreTwoOnACoarseMesh)
{
  EXPECT_EQ(TwoCorners(0.05, 1, 40.0).CurvesAfter(), 5U);
}
