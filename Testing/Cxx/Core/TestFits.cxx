// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Fits/FaceFit.h"

#include "Core/Fits/FirstGuess.h"
#include "Features.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

// The shapes lie anywhere in space: turned by Turn, moved by Shift.

namespace
{
constexpr double Tolerance = 0.03; // the filter's default
const Eigen::Matrix3d Turn =
  Eigen::AngleAxisd(0.9, Vec3(1.0, -2.0, 3.0).normalized()).toRotationMatrix();
const Vec3 Shift(10.0, -20.0, 5.0);
const Vec3 Axis = Turn * Vec3::UnitZ();

Mesh Placed(Mesh mesh)
{
  for (Vec3& point : mesh.Points)
  {
    point = Turn * point + Shift;
  }
  return mesh;
}

FaceFit Fit(const Mesh& mesh)
{
  const std::vector<FaceFit> fits =
    FitFaces(mesh, std::vector<Index>(mesh.Triangles.size(), 0), 1, Tolerance, Monitor());
  return fits.at(0);
}

double DistanceFromAxis(const Primitive& shape, const Vec3& point)
{
  return (point - shape.Point).cross(shape.Axis).norm();
}

/// A part of a mesh: the triangles whose centroids a test accepts.
template <typename Accept>
Mesh Part(Mesh mesh, Accept&& accept)
{
  std::vector<Triangle> kept;
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    if (accept(Corners(mesh, t).Centroid()))
    {
      kept.push_back(mesh.Triangles[t]);
    }
  }
  mesh.Triangles = kept;
  return mesh;
}

/// The flank of a cone about z with its apex at the origin, from radius `low` to `high`.
Mesh Flank(double halfAngle, double low, double high)
{
  Mesh mesh = Tube(1.0, 40, 5, 1.0);
  for (Vec3& point : mesh.Points)
  {
    const double out = low + (high - low) * point.z() / 5.0;
    point = Vec3(out * point.x(), out * point.y(), out / std::tan(halfAngle));
  }
  return mesh;
}
}

TEST(Fits, APlane)
{
  const FaceFit fit = Fit(Placed(FlatGrid(6, 4)));
  EXPECT_EQ(fit.Shape.Kind, PrimitiveKind::Plane);
  EXPECT_NEAR((fit.Shape.Axis - Axis).norm(), 0.0, 1e-12);
  EXPECT_NEAR(fit.Shape.Distance(Shift), 0.0, 1e-12);
  EXPECT_NEAR(fit.Residual, 0.0, 1e-12);
}

TEST(Fits, ASphere)
{
  const Mesh sphere = Sphere(7.0, 8);
  for (const bool whole : { true, false })
  {
    const Mesh part = whole ? sphere : Part(sphere, [](const Vec3& p) { return p.z() > 4.0; });
    const FaceFit fit = Fit(Placed(part));
    EXPECT_EQ(fit.Shape.Kind, PrimitiveKind::Sphere);
    EXPECT_NEAR((fit.Shape.Point - Shift).norm(), 0.0, 1e-9);
    EXPECT_NEAR(fit.Shape.Radius, 7.0, 1e-9);
    EXPECT_NEAR(fit.Residual, 0.0, 1e-9);
  }
}

TEST(Fits, ACylinder)
{
  for (const Index rows : { 1, 6 }) // a tessellation has but two rings of points
  {
    const Mesh tube = Tube(3.0, 40, rows, 10.0 / rows);
    for (const bool whole : { true, false })
    {
      const Mesh part = whole ? tube : Part(tube, [](const Vec3& p) { return p.x() > 1.5; });
      const FaceFit fit = Fit(Placed(part));
      EXPECT_EQ(fit.Shape.Kind, PrimitiveKind::Cylinder);
      EXPECT_NEAR(std::abs(fit.Shape.Axis.dot(Axis)), 1.0, 1e-12);
      EXPECT_NEAR(fit.Shape.Radius, 3.0, 1e-8);
      EXPECT_NEAR(DistanceFromAxis(fit.Shape, Shift), 0.0, 1e-8);
      EXPECT_NEAR(fit.Residual, 0.0, 1e-8);
    }
  }
}

TEST(Fits, TwoRingsOfPointsAreACylinderThoughASphereGoesThroughThemToo)
{
  for (const double height : { 0.3, 1.0, 3.0, 10.0 })
  {
    const FaceFit fit = Fit(Placed(Tube(3.0, 500, 1, height)));
    EXPECT_EQ(fit.Shape.Kind, PrimitiveKind::Cylinder) << height;
    EXPECT_NEAR(fit.Shape.Radius, 3.0, 1e-6);
  }
}

TEST(Fits, APlaneOfSixDigitsIsNoHugeCylinder)
{
  Mesh grid = Placed(FlatGrid(20, 20));
  for (Vec3& point : grid.Points)
  {
    point = (point * 1e4).array().round() / 1e4;
  }
  EXPECT_EQ(Fit(grid).Shape.Kind, PrimitiveKind::Plane);
}

TEST(Fits, ACone)
{
  for (const double halfAngle : { 0.2, 0.7, 1.2 })
  {
    const FaceFit fit = Fit(Placed(Flank(halfAngle, 1.0, 4.0)));
    EXPECT_EQ(fit.Shape.Kind, PrimitiveKind::Cone);
    EXPECT_NEAR((fit.Shape.Axis - Axis).norm(), 0.0, 1e-8);
    EXPECT_NEAR((fit.Shape.Point - Shift).norm(), 0.0, 1e-7);
    EXPECT_NEAR(fit.Shape.HalfAngle, halfAngle, 1e-8);
    EXPECT_NEAR(fit.Residual, 0.0, 1e-8);
  }
}

TEST(Fits, ATorus)
{
  const Mesh torus = Torus(5.0, 1.0, 60, 24);
  for (const bool whole : { true, false })
  {
    const Mesh part =
      whole ? torus : Part(torus, [](const Vec3& p) { return p.x() > 0.0 && p.z() > 0.0; });
    const FaceFit fit = Fit(Placed(part)); // a fillet round a quarter of a boss
    EXPECT_EQ(fit.Shape.Kind, PrimitiveKind::Torus);
    EXPECT_NEAR(std::abs(fit.Shape.Axis.dot(Axis)), 1.0, 1e-8);
    EXPECT_NEAR((fit.Shape.Point - Shift).norm(), 0.0, 1e-6);
    EXPECT_NEAR(fit.Shape.Radius, 5.0, 1e-6);
    EXPECT_NEAR(fit.Shape.MinorRadius, 1.0, 1e-6);
    EXPECT_NEAR(fit.Residual, 0.0, 1e-6);
  }
}

TEST(Fits, NothingToAFreeForm)
{
  Mesh saddle = FlatGrid(20, 20);
  for (Vec3& p : saddle.Points)
  {
    p.z() = 0.02 * (p.x() - 10.0) * (p.x() - 10.0) - 0.03 * (p.y() - 10.0) * (p.y() - 10.0) +
      0.002 * p.x() * p.y() * (p.x() - 7.0);
  }
  const FaceFit fit = Fit(Placed(saddle));
  EXPECT_EQ(fit.Shape.Kind, PrimitiveKind::FreeForm);
  EXPECT_STREQ(NameOf(fit.Shape.Kind), "free-form");
  EXPECT_GT(fit.Residual, Tolerance);
}

TEST(Fits, WithinNoise)
{
  Dice dice;
  const auto noisy = [&](Mesh mesh)
  {
    for (Vec3& point : mesh.Points)
    {
      point += 0.005 * Vec3(dice(), dice(), dice());
    }
    return mesh;
  };
  EXPECT_EQ(Fit(noisy(FlatGrid(20, 20))).Shape.Kind, PrimitiveKind::Plane);
  const FaceFit sphere = Fit(noisy(Sphere(7.0, 12)));
  EXPECT_EQ(sphere.Shape.Kind, PrimitiveKind::Sphere);
  EXPECT_NEAR(sphere.Shape.Radius, 7.0, 0.005);
  const FaceFit cylinder = Fit(noisy(Tube(6.0, 40, 10, 1.0)));
  EXPECT_EQ(cylinder.Shape.Kind, PrimitiveKind::Cylinder);
  EXPECT_NEAR(cylinder.Shape.Radius, 6.0, 0.005);
  EXPECT_LT(cylinder.Residual, 0.005);
}

TEST(Fits, EachFaceByItself)
{
  Mesh mesh = FlatGrid(4, 4);
  const std::size_t grid = mesh.Triangles.size();
  Append(mesh, Sphere(7.0, 8));
  std::vector<Index> ids(mesh.Triangles.size(), 0);
  std::fill(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(grid), 1);
  const std::vector<FaceFit> fits = FitFaces(mesh, ids, 2, Tolerance, Monitor());
  ASSERT_EQ(fits.size(), 2u);
  EXPECT_EQ(fits[0].Shape.Kind, PrimitiveKind::Sphere);
  EXPECT_EQ(fits[1].Shape.Kind, PrimitiveKind::Plane);
}

TEST(Fits, AFaceWithoutAreaHasNoShape)
{
  Mesh mesh;
  mesh.Points.assign(3, Vec3(1.0, 1.0, 1.0));
  mesh.Triangles = { { 0, 1, 2 } };
  EXPECT_EQ(Fit(mesh).Shape.Kind, PrimitiveKind::FreeForm);
  EXPECT_EQ(Fit(mesh).Residual, 0.0);
}

TEST(Fits, DistancesAndNormalsAgree)
{
  // The distance grows along the normal, by as much as one goes.
  Primitive shape;
  shape.Point = Shift;
  shape.Axis = Axis;
  shape.Radius = 5.0;
  shape.MinorRadius = 1.0;
  shape.HalfAngle = 0.5;
  const Vec3 point = Shift + Turn * Vec3(4.0, 3.0, 6.0);
  for (const PrimitiveKind kind : { PrimitiveKind::Plane, PrimitiveKind::Sphere,
         PrimitiveKind::Cylinder, PrimitiveKind::Cone, PrimitiveKind::Torus })
  {
    shape.Kind = kind;
    const Vec3 normal = shape.Normal(point);
    EXPECT_NEAR(normal.norm(), 1.0, 1e-12) << NameOf(kind);
    EXPECT_NEAR(shape.Distance(point + 0.1 * normal) - shape.Distance(point), 0.1, 1e-12)
      << NameOf(kind);
  }
}
