// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Features/CurveProperties.h"

#include "Core/Features/Resampling.h"
#include "Features.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
/// A tube of ten units with the caps on: fans around a point in the middle.
Mesh CappedTube(double radius, Index segments)
{
  Mesh mesh = Tube(radius, segments, 1, 10.0);
  const Index bottom = mesh.VertexCount();
  mesh.Points.emplace_back(0.0, 0.0, 0.0);
  mesh.Points.emplace_back(0.0, 0.0, 10.0);
  for (Index i = 0; i < segments; ++i)
  {
    const Index next = (i + 1) % segments;
    mesh.Triangles.push_back({ bottom, next, i });
    mesh.Triangles.push_back({ bottom + 1, segments + i, segments + next });
  }
  return mesh;
}

std::vector<CurveProperties> Describe(FeatureMesh& mesh)
{
  OrientCurves(mesh.Edges, mesh.Faces.Ids, mesh.Network.Curves);
  std::vector<CurveProperties> properties;
  for (const Curve& curve : mesh.Network.Curves)
  {
    properties.push_back(DescribeCurve(curve, mesh.Edges, mesh.Faces.Ids, mesh.Surface.Points));
  }
  return properties;
}
}

TEST(CurveProperties, OfACylindersRims)
{
  constexpr Index Segments = 64;
  FeatureMesh mesh(CappedTube(3.0, Segments));
  const auto curves = Describe(mesh);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_TRUE(mesh.Network.Corners.empty());
  ASSERT_EQ(mesh.Faces.Measures.size(), 3u);
  for (const CurveProperties& curve : curves)
  {
    EXPECT_TRUE(curve.Closed);
    EXPECT_NEAR(curve.Length, 2.0 * Segments * 3.0 * std::sin(Pi / Segments), 1e-12);
    EXPECT_EQ(curve.Kind, EdgeKind::Convex);
    EXPECT_NEAR(curve.MeanAngle, 90.0, 1e-4);
    EXPECT_NEAR(curve.LeastAngle, 90.0, 1e-4);
    EXPECT_NEAR(curve.LargestAngle, 90.0, 1e-4);
    EXPECT_EQ(curve.LeftSurface, 0) << "the side, which is the largest";
  }
  EXPECT_NE(curves[0].RightSurface, curves[1].RightSurface);
}

TEST(CurveProperties, TheLowerSurfaceIsOnTheLeft)
{
  FeatureMesh mesh(Box(3, 4, 5));
  Describe(mesh);
  const std::vector<Vec3> normals = UnitNormals(mesh.Surface, 1.0);
  for (const Curve& curve : mesh.Network.Curves)
  {
    const FeatureEdge& edge = *FindFeature(mesh.Edges, curve[0], curve[1]);
    const bool leftIsLower = mesh.Faces.Ids[edge.Left] < mesh.Faces.Ids[edge.Right];
    const Index low = leftIsLower ? edge.Left : edge.Right;
    const Index high = leftIsLower ? edge.Right : edge.Left;
    const Vec3 along = mesh.Surface.Points[curve[1]] - mesh.Surface.Points[curve[0]];
    // To the left of who walks along a convex edge lies what falls away there: against its normal
    // lies the other face.
    EXPECT_GT(along.dot(normals[low].cross(normals[high])), 0.0);
  }
}

TEST(CurveProperties, TheBoundaryHasItsSurfaceOnTheLeft)
{
  FeatureMesh mesh(FlatGrid(4, 3));
  const auto curves = Describe(mesh);
  ASSERT_EQ(curves.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(curves[i].Kind, EdgeKind::Boundary);
    EXPECT_EQ(curves[i].LeftSurface, 0);
    EXPECT_EQ(curves[i].RightSurface, NoIndex);
    const Vec3 a = mesh.Surface.Points[mesh.Network.Curves[i].front()];
    const Vec3 b = mesh.Surface.Points[mesh.Network.Curves[i].back()];
    const Vec3 middle(2.0, 1.5, 0.0);
    EXPECT_GT((b - a).cross(middle - a).z(), 0.0) << "anticlockwise, seen from above";
  }
}

TEST(CurveProperties, OfANonManifoldEdge)
{
  FeatureMesh mesh(Wings(3));
  int found = 0;
  for (const CurveProperties& curve : Describe(mesh))
  {
    found += curve.Kind == EdgeKind::NonManifold ? 1 : 0;
  }
  EXPECT_EQ(found, 1);
}

TEST(CurveProperties, WhatPrevailsMakesTheKind)
{
  // Up by 60 degrees for three units, down by 40 for one: with the fold in the order of Fold.
  for (const bool valley : { false, true })
  {
    FeatureMesh mesh(Fold(3, 4, valley ? -60.0 : 60.0));
    std::vector<FeatureEdge> edges = mesh.Edges;
    for (FeatureEdge& edge : edges)
    {
      const bool other = IsFold(edge.Kind) && mesh.Surface.Points[edge.A].y() > 2.5;
      edge.Kind = other ? (valley ? EdgeKind::Convex : EdgeKind::Concave) : edge.Kind;
      edge.DihedralAngle = other ? 40.0 : edge.DihedralAngle;
    }
    const Curve curve = { 3, 10, 17, 24, 31 };
    const CurveProperties properties =
      DescribeCurve(curve, edges, mesh.Faces.Ids, mesh.Surface.Points);
    EXPECT_EQ(properties.Kind, valley ? EdgeKind::Concave : EdgeKind::Convex);
    EXPECT_NEAR(properties.MeanAngle, 55.0, 1e-4);
    EXPECT_NEAR(properties.LeastAngle, 40.0, 1e-4);
    EXPECT_NEAR(properties.LargestAngle, 60.0, 1e-4);
  }
}

TEST(CurveProperties, TangentsAndAnglesFollowTheCurve)
{
  FeatureMesh mesh(CappedTube(3.0, 64));
  Describe(mesh);
  for (const Curve& curve : mesh.Network.Curves)
  {
    const std::vector<Vec3> tangents = Tangents(curve, mesh.Surface.Points);
    const std::vector<double> angles = AnglesAlong(curve, mesh.Edges);
    ASSERT_EQ(tangents.size(), 64u);
    ASSERT_EQ(angles.size(), 64u);
    for (std::size_t i = 0; i < 64; ++i)
    {
      const Vec3 out = mesh.Surface.Points[curve[i]];
      EXPECT_NEAR(tangents[i].norm(), 1.0, 1e-12);
      EXPECT_NEAR(tangents[i].z(), 0.0, 1e-12);
      EXPECT_NEAR(tangents[i].x() * out.x() + tangents[i].y() * out.y(), 0.0, 1e-12);
      EXPECT_NEAR(angles[i], 90.0, 1e-4);
    }
  }
}

TEST(Resampling, PutsPointsAtEvenDistances)
{
  const std::vector<Vec3> points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 2, 0) };
  const Curve curve = { 0, 1, 2 };
  const std::vector<CurvePoint> samples = Resampled(curve, points, 0.7); // 3 / 0.7 is about 4
  ASSERT_EQ(samples.size(), 5u);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double along = samples[i].At == 0 ? samples[i].Share : 1.0 + 2.0 * samples[i].Share;
    EXPECT_NEAR(samples[i].At == 2 ? 3.0 : along, 0.75 * static_cast<double>(i), 1e-12);
  }
}

TEST(Resampling, KeepsAClosedCurveClosed)
{
  const std::vector<Vec3> points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0) };
  EXPECT_EQ(Resampled({ 0, 1, 2, 3, 0 }, points, 0.5).size(), 8u);
  EXPECT_EQ(Resampled({ 0, 1, 2, 3, 0 }, points, 100.0).size(), 3u) << "not less than a triangle";
  EXPECT_EQ(Resampled({ 0, 1, 2, 3 }, points, 100.0).size(), 2u);
  EXPECT_EQ(VerticesOf({ 0, 1, 2, 3, 0 }).size(), 4u);
}

TEST(Resampling, RefusesAStepThatWouldFillTheMemory)
{
  const std::vector<Vec3> points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 2, 0) };
  const std::vector<Curve> curves = { { 0, 1, 2 }, { 0, 1 } };
  EXPECT_EQ(ProblemWithStep(curves, points, 4.1 / MostPointsAdded), "");
  EXPECT_EQ(ProblemWithStep(curves, points, 1e9), "") << "however many curves there are";
  EXPECT_EQ(ProblemWithStep(curves, points, 1e-12),
    "ResampleStep is too small: 1e-12 would put 4e+12 points on the curves, and 1e+06 is the most");
  constexpr double Least = std::numeric_limits<double>::denorm_min();
  EXPECT_NE(ProblemWithStep(curves, points, Least), "");
}
