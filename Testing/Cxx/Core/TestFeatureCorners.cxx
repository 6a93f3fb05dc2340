// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Features/FeatureCorners.h"
#include "Core/Features/Tips.h"

#include "Features.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
/// A cone about z with its apex at the origin, `rows` rows of unit height; it opens downwards. The
/// apex is vertex 0.
Mesh Cone(double halfAngle, Index segments, Index rows)
{
  Mesh mesh;
  mesh.Points.emplace_back(0.0, 0.0, 0.0);
  for (Index row = 1; row <= rows; ++row)
  {
    for (Index i = 0; i < segments; ++i)
    {
      const double angle = 2.0 * Pi * i / segments;
      const double out = row * std::tan(halfAngle * Pi / 180.0);
      mesh.Points.emplace_back(out * std::cos(angle), out * std::sin(angle), -row);
    }
  }
  for (Index i = 0; i < segments; ++i)
  {
    const Index next = (i + 1) % segments;
    mesh.Triangles.push_back({ 0, 1 + i, 1 + next });
    for (Index row = 1; row < rows; ++row)
    {
      const Index a = 1 + (row - 1) * segments;
      AddQuad(mesh, a + i, a + segments + i, a + segments + next, a + next);
    }
  }
  return mesh;
}

std::vector<FeatureCorner> CornersOf(const FeatureMesh& mesh)
{
  std::vector<FeatureCorner> corners;
  FindFeatureCorners(mesh.Surface, mesh.Adjacency,
    FindFolds(mesh.Surface, mesh.Adjacency, Monitor()), mesh.Network, mesh.Edges, 30.0, Monitor(),
    corners);
  return corners;
}

/// Mirrors a mesh in space, inside out, so that what was convex is concave.
Mesh InsideOut(Mesh mesh)
{
  for (Triangle& triangle : mesh.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

std::vector<FeatureCorner> Tips(const Mesh& mesh)
{
  std::vector<FeatureCorner> tips;
  for (const FeatureCorner& corner : CornersOf(FeatureMesh(mesh)))
  {
    if (corner.Tip)
    {
      tips.push_back(corner);
    }
  }
  return tips;
}
}

TEST(FeatureCorners, OfABox)
{
  for (const bool pocket : { false, true })
  {
    const Mesh box = pocket ? InsideOut(Box(3, 4, 5)) : Box(3, 4, 5);
    const std::vector<FeatureCorner> corners = CornersOf(FeatureMesh(box));
    ASSERT_EQ(corners.size(), 8u);
    std::vector<int> ends(12, 0);
    for (const FeatureCorner& corner : corners)
    {
      EXPECT_EQ(corner.Valence, 3);
      EXPECT_EQ(corner.Kind, pocket ? CornerKind::Concave : CornerKind::Convex);
      EXPECT_FALSE(corner.Tip);
      EXPECT_EQ(corner.Curves.size(), 3u);
      EXPECT_TRUE(std::is_sorted(corner.Curves.begin(), corner.Curves.end()));
      for (const Index curve : corner.Curves)
      {
        ++ends.at(static_cast<std::size_t>(curve));
      }
    }
    EXPECT_EQ(ends, std::vector<int>(12, 2)) << "every curve ends at two corners";
  }
}

TEST(FeatureCorners, OfANotchAreSaddles)
{
  // An L, extruded: its six corners at each end, one of them where a concave edge meets two convex.
  const std::vector<Vec3> profile = { Vec3(0, 0, 0), Vec3(0, 0, 2), Vec3(1, 0, 2), Vec3(1, 0, 1),
    Vec3(2, 0, 1), Vec3(2, 0, 0) };
  Mesh mesh = Extrude(profile, 1, Vec3(0.0, 1.0, 0.0), true);
  AddQuad(mesh, 0, 5, 4, 3);
  AddQuad(mesh, 0, 3, 2, 1);
  AddQuad(mesh, 9, 10, 11, 6);
  AddQuad(mesh, 7, 8, 9, 6);
  int saddles = 0;
  const std::vector<FeatureCorner> corners = CornersOf(FeatureMesh(mesh));
  EXPECT_EQ(corners.size(), 12u);
  for (const FeatureCorner& corner : corners)
  {
    const bool inner = corner.Vertex == 3 || corner.Vertex == 9;
    EXPECT_EQ(corner.Kind, inner ? CornerKind::Saddle : CornerKind::Convex) << corner.Vertex;
    saddles += corner.Kind == CornerKind::Saddle ? 1 : 0;
  }
  EXPECT_EQ(saddles, 2);
}

TEST(FeatureCorners, OfTheBoundaryHaveNoKind)
{
  for (const FeatureCorner& corner : CornersOf(FeatureMesh(FlatGrid(3, 3))))
  {
    EXPECT_EQ(corner.Kind, CornerKind::None);
    EXPECT_EQ(corner.Valence, 2);
  }
}

TEST(FeatureCorners, TheApexOfAConeIsATip)
{
  for (const double halfAngle : { 5.0, 20.0, 45.0, 70.0 })
  {
    for (const bool dent : { false, true })
    {
      const Mesh cone = Cone(halfAngle, 48, 6);
      const std::vector<FeatureCorner> tips = Tips(dent ? InsideOut(cone) : cone);
      ASSERT_EQ(tips.size(), 1u) << halfAngle;
      EXPECT_EQ(tips[0].Vertex, 0);
      EXPECT_EQ(tips[0].Valence, 0);
      EXPECT_TRUE(tips[0].Curves.empty());
      EXPECT_EQ(tips[0].Kind, dent ? CornerKind::Concave : CornerKind::Convex);
    }
  }
}

TEST(FeatureCorners, ABluntOneIsNone)
{
  EXPECT_TRUE(Tips(Cone(80.0, 48, 6)).empty()) << "flanks that fold by 20 degrees, not by 30";
}

TEST(FeatureCorners, NothingIsATipOnSmoothSurfaces)
{
  EXPECT_TRUE(Tips(Sphere(5.0, 4)).empty());
  EXPECT_TRUE(Tips(Sphere(20.0, 30)).empty());
  EXPECT_TRUE(Tips(Torus(4.0, 1.0, 40, 20)).empty());
}

TEST(FeatureCorners, NorInNoise)
{
  Mesh plate = FlatGrid(150, 150);
  Dice dice;
  for (Vec3& point : plate.Points)
  {
    point += 0.15 * Vec3(dice(), dice(), dice());
  }
  std::vector<FeatureCorner> corners;
  const Connectivity connectivity(plate);
  FindFeatureCorners(plate, connectivity, FindFolds(plate, connectivity, Monitor()), CurveNetwork(),
    {}, 30.0, Monitor(), corners);
  EXPECT_TRUE(corners.empty());
}

TEST(FeatureCorners, ATipIsFoundWhateverFoldsAreKept)
{
  const Mesh cone = Cone(30.0, 24, 6);
  const Connectivity connectivity(cone);
  for (const double least : { 0.0, LeastFoldAtTips(30.0), 1.9 })
  {
    std::vector<FeatureCorner> corners;
    FindFeatureCorners(cone, connectivity, FindFolds(cone, connectivity, Monitor(), least),
      CurveNetwork(), {}, 30.0, Monitor(), corners);
    ASSERT_EQ(corners.size(), 1u) << least;
    EXPECT_EQ(corners[0].Vertex, 0);
  }
}
