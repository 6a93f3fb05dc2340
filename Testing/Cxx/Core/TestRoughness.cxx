// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Features.h"

#include "Core/Robust/Denoised.h"
#include "Core/Robust/Faces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr double Radius = 20.0;
constexpr double NoiseSize =
  0.15; // of about unit edges: what normal noise of a tenth of an edge is

struct Measured
{
  explicit Measured(const Mesh& mesh)
    : Adjacency(mesh)
    , Scales(LocalScales(mesh, this->Adjacency))
    , Rough(MeasureRoughness(mesh, this->Adjacency, this->Scales))
  {
  }
  Connectivity Adjacency;
  std::vector<double> Scales;
  Roughness Rough;
};

double RmsOffSphere(const std::vector<Vec3>& points)
{
  double squares = 0.0;
  for (const Vec3& point : points)
  {
    squares += std::pow(point.norm() - Radius, 2.0);
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}
}

TEST(RoughnessOf, SmoothMeshesIsNone)
{
  for (const Mesh& mesh : { Sphere(Radius, 30), FlatGrid(40, 40), Torus(20.0, 8.0, 120, 50),
         Fold(20, 40, 90.0), Box(30, 30, 30) })
  {
    EXPECT_EQ(Measured(mesh).Rough.Degree, 0.0);
  }
}

TEST(RoughnessOf, NoisyMeshesIsWhole)
{
  for (const Mesh& mesh : { Sphere(Radius, 30), FlatGrid(40, 40), Box(30, 30, 30) })
  {
    const Roughness rough = Measured(Noisy(mesh, NoiseSize)).Rough;
    EXPECT_EQ(rough.Degree, 1.0);
    EXPECT_EQ(rough.Noise, 1.0);
  }
}

TEST(RoughnessOf, FewVerticesIsUnknownAndCountsAsNone)
{
  EXPECT_EQ(Measured(Wings(2)).Rough.Degree, 0.0);
  EXPECT_EQ(Measured(Mesh()).Rough.Degree, 0.0);
}

TEST(RoughnessOf, AnySizeIsTheSame)
{
  Mesh mesh = Noisy(Sphere(Radius, 30), NoiseSize);
  const double height = Measured(mesh).Rough.Height;
  for (Vec3& point : mesh.Points)
  {
    point *= 1024.0; // a power of two: no rounding
  }
  EXPECT_DOUBLE_EQ(Measured(mesh).Rough.Height, height);
}

TEST(Denoised, SphereIsNearerToTheSphere)
{
  const Mesh noisy = Noisy(Sphere(Radius, 30), NoiseSize);
  const Measured measured(noisy);
  const std::vector<Vec3> points =
    DenoisedPoints(noisy, measured.Adjacency, measured.Scales, measured.Rough, Monitor());
  ASSERT_EQ(points.size(), noisy.Points.size());
  // Some 75 points in a window, six of which the surface takes: about a third of the noise is left.
  EXPECT_LT(RmsOffSphere(points), 0.4 * RmsOffSphere(noisy.Points));
}

TEST(Denoised, EdgeStaysWhereItIs)
{
  const Mesh clean = Box(30, 30, 30);
  const Mesh noisy = Noisy(clean, NoiseSize);
  const Measured measured(noisy);
  const std::vector<Vec3> points =
    DenoisedPoints(noisy, measured.Adjacency, measured.Scales, measured.Rough, Monitor());
  double off = 0.0;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    off = std::max(off, (points[v] - clean.Points[v]).norm());
  }
  EXPECT_LT(off, 1.0); // of an edge: a plain average over the window takes corners back by two
}

TEST(Denoised, StopsWhenTold)
{
  const Mesh noisy = Noisy(Sphere(Radius, 20), NoiseSize);
  const Measured measured(noisy);
  const Monitor stop([](double) { return false; });
  EXPECT_TRUE(
    DenoisedPoints(noisy, measured.Adjacency, measured.Scales, measured.Rough, stop).empty());
}
