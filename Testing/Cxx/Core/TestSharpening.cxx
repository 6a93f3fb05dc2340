// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/EdgeLengths.h"
#include "Core/Sharpening.h"

#include "Core/Geometry.h"
#include "Core/Thinning.h"
#include "Core/Ussod.h"
#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
/// All the steps in a row.
struct Recovered
{
  std::vector<int> Rounds;
  Skeleton TheSkeleton;
  std::vector<Vec3> Points;

  explicit Recovered(const Mesh& mesh, double window, double sharpAngle = 41.4)
  {
    const Connectivity connectivity(mesh);
    const double edge = AverageEdgeLength(mesh, connectivity);
    const std::vector<double> differences = NormalDifferences(
      mesh, connectivity, UnitNormals(mesh, edge), window, WindowSearch::Connected, Monitor());
    this->Rounds = ThinningRounds(
      mesh, connectivity, SharpRegion(differences, sharpAngle), differences, Monitor());
    this->TheSkeleton = TraceSkeleton(mesh, connectivity, this->Rounds);
    this->Points =
      SharpenedPoints(mesh, connectivity, this->Rounds, this->TheSkeleton, window, edge, Monitor());
  }
};

constexpr Index Width = 6;
constexpr Index Columns = 2 * Width + 1;
constexpr Index Length = 20;

/// Away from the ends of an extrusion, whose boundary vertices thinning has to keep.
bool FarFromTheEnds(Index vertex)
{
  return vertex / Columns >= 5 && vertex / Columns <= Length - 5;
}

/// The distance to the surface of the box (0, 0, 0) to (size, size, size).
double DistanceToBox(const Vec3& p, double size)
{
  const Vec3 outside = (p - Vec3::Constant(0.5 * size)).cwiseAbs() - Vec3::Constant(0.5 * size);
  return std::abs(outside.cwiseMax(0.0).norm() + std::min(0.0, outside.maxCoeff()));
}

/// A box whose edges and corners are cut off: their vertices sunk by `depth` along each axis.
Mesh ChamferedBox(Index size, double depth)
{
  Mesh mesh = Box(size, size, size);
  for (Vec3& p : mesh.Points)
  {
    const Vec3 inwards = (p.array() == 0.0).cast<double>() - (p.array() == size).cast<double>();
    if (inwards.squaredNorm() > 1.0)
    {
      p += depth * inwards;
    }
  }
  return mesh;
}
}

class SharpeningOfAFold : public ::testing::TestWithParam<double>
{
};

TEST_P(SharpeningOfAFold, GivesBackTheEdgeThatAChamferTook)
{
  // Both planes are exact up to the chamfer, so the edge is known exactly.
  const Mesh mesh = ChamferedFold(Width, Length, GetParam(), 0.3);
  const std::vector<Vec3> truth = Fold(Width, Length, GetParam()).Points;
  const Recovered recovered(mesh, 0.9, 30.0);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (!FarFromTheEnds(v))
    {
      continue;
    }
    const Vec3& p = recovered.Points[v];
    const Index column = v % Columns - Width;
    if (column == 0)
    {
      EXPECT_EQ(recovered.TheSkeleton.Roles[v], SkeletonRole::Branch);
      EXPECT_NEAR(p.x(), 0.0, 1e-12) << "on the edge";
      EXPECT_NEAR(p.z(), 0.0, 1e-12);
      EXPECT_NEAR(p.y(), truth[v].y(), 0.5) << "near its place along the edge";
    }
    else
    {
      const double half = 0.5 * GetParam() * Pi / 180.0;
      const Vec3 normal(column > 0 ? std::sin(half) : -std::sin(half), 0.0, std::cos(half));
      EXPECT_NEAR(normal.dot(p), 0.0, 1e-12) << "on its own plane";
    }
  }
}

TEST_P(SharpeningOfAFold, LeavesIntactVerticesToTheLastBit)
{
  const Mesh mesh = ChamferedFold(Width, Length, GetParam(), 0.3);
  const Recovered recovered(mesh, 0.9, 30.0);
  Index intact = 0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (recovered.Rounds[v] == NeverSharp)
    {
      EXPECT_EQ(recovered.Points[v], mesh.Points[v]);
      ++intact;
    }
  }
  EXPECT_GE(intact, (Columns - 5) * (Length + 1)) << "the sharp region is a narrow strip";
}

INSTANTIATE_TEST_SUITE_P(
  Angles, SharpeningOfAFold, ::testing::Values(60.0, 90.0, 120.0, -75.0, -120.0));

TEST(Sharpening, GivesABoxItsEdgesAndCornersBack)
{
  constexpr Index Size = 12;
  const Mesh mesh = ChamferedBox(Size, 0.3);
  const std::vector<Vec3> truth = Box(Size, Size, Size).Points;
  const Recovered recovered(mesh, 0.9);
  double before = 0.0;
  double after = 0.0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    before = std::max(before, DistanceToBox(mesh.Points[v], Size));
    after = std::max(after, DistanceToBox(recovered.Points[v], Size));
    const bool isCorner = (truth[v].array() == 0.0 || truth[v].array() == Size).all();
    if (isCorner)
    {
      EXPECT_EQ(recovered.TheSkeleton.Roles[v], SkeletonRole::Joint);
      EXPECT_LE((recovered.Points[v] - truth[v]).norm(), 1e-12) << truth[v].transpose();
    }
  }
  EXPECT_NEAR(before, 0.3, 1e-12);
  EXPECT_LE(after, 1e-12) << "all on planes that meet exactly";
}

TEST(Sharpening, KeepsAnExactBoxAsItIs)
{
  constexpr Index Size = 10;
  const Mesh mesh = Box(Size, Size, Size);
  for (const Vec3& p : Recovered(mesh, 0.9).Points)
  {
    EXPECT_LE(DistanceToBox(p, Size), 1e-12);
  }
}

TEST(Sharpening, DoesNotKnowWhereToGoWithoutAStaticTriangle)
{
  const Mesh mesh = Box(2, 2, 2); // every window holds an edge
  const Recovered recovered(mesh, 1.5);
  EXPECT_EQ(std::count(recovered.Rounds.begin(), recovered.Rounds.end(), NeverSharp), 0);
  EXPECT_EQ(recovered.Points, mesh.Points);
}

TEST(Sharpening, LeavesASmoothMeshAlone)
{
  const Mesh mesh = Torus(20.0, 5.0, 100, 40);
  EXPECT_EQ(Recovered(mesh, 1.0).Points, mesh.Points);
}

TEST(Sharpening, MovesAVertexFourEdgesFromItsNeighboursAtMost)
{
  // Two planes at 10 degrees, apart by a step: they would meet 20 units away.
  const double slope = std::tan(10.0 * Pi / 180.0);
  std::vector<Vec3> profile;
  for (Index i = -Width; i <= Width; ++i)
  {
    const double right = slope * (i + 20.0);
    profile.emplace_back(i, 0.0, i < 0 ? 0.0 : (i > 0 ? right : 0.5 * right));
  }
  const Mesh mesh = Extrude(profile, Length, Vec3(0.0, 1.0, 0.0));
  std::vector<int> rounds(mesh.Points.size(), NeverSharp);
  for (Index row = 0; row <= Length; ++row)
  {
    rounds[row * Columns + Width] = 1;
  }
  const Connectivity connectivity(mesh);
  const double edge = AverageEdgeLength(mesh, connectivity);
  const std::vector<Vec3> points = SharpenedPoints(
    mesh, connectivity, rounds, TraceSkeleton(mesh, connectivity, rounds), 0.9, edge, Monitor());
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (FarFromTheEnds(v) && rounds[v] == 1)
    {
      // Branches move together, so the centre is that of the neighbours' first positions.
      const Vec3 centre = 0.5 * (mesh.Points[v - Columns] + mesh.Points[v + Columns]);
      EXPECT_NEAR((points[v] - centre).norm(), 4.0 * edge, 1e-12);
    }
  }
}

TEST(Sharpening, ARemovedVertexHearsTheNearestStaticTrianglesOnly)
{
  // A column of removed vertices, 0.36 from plane z = 0 and 1.5 or more from a plane that falls off
  // to the right. The support is half a window, or as many tenths more as it needs.
  const Index middle = 4;
  const Vec3 fall(0.5, 0.0, -std::sqrt(0.75));
  std::vector<Vec3> profile = { Vec3(-3.3, 0, 0), Vec3(-2.3, 0, 0), Vec3(-1.3, 0, 0),
    Vec3(-0.3, 0, 0), Vec3(0.0, 0.0, 0.2) };
  for (int i = 0; i < 4; ++i)
  {
    profile.emplace_back(Vec3(1.5, 0.0, 0.0) + static_cast<double>(i) * fall);
  }
  const Index width = static_cast<Index>(profile.size());
  const Mesh mesh = Extrude(profile, 12, Vec3(0.0, 1.0, 0.0));
  std::vector<int> rounds(mesh.Points.size(), NeverSharp);
  for (Index row = 0; row <= 12; ++row)
  {
    rounds[row * width + middle] = 1;
  }
  rounds[0] = 2; // a skeleton somewhere else
  const Connectivity connectivity(mesh);
  const Skeleton skeleton = TraceSkeleton(mesh, connectivity, rounds);
  const Index v = 6 * width + middle;
  const auto moved = [&](double window)
  {
    return SharpenedPoints(mesh, connectivity, rounds, skeleton, window,
      AverageEdgeLength(mesh, connectivity), Monitor())[v];
  };
  Vec3 centre = Vec3::Zero();
  for (const Index neighbor : connectivity.NeighborsOfVertex[v])
  {
    centre += mesh.Points[neighbor] / connectivity.NeighborsOfVertex[v].size();
  }
  const Vec3 onNearPlane(centre.x(), centre.y(), 0.0);
  EXPECT_LE((moved(1.0) - onNearPlane).norm(), 1e-12) << "within half a window";
  EXPECT_LE((moved(0.5) - onNearPlane).norm(), 1e-12) << "after growing";
  const Vec3 onBoth(1.5, centre.y(), 0.0);
  EXPECT_LE((moved(4.0) - onBoth).norm(), 1e-12) << "half a window reaches both planes";
}

TEST(Sharpening, AJointSeesTheBranchesWhereTheyHaveGone)
{
  // On bulging sides no two planes agree, so it shows which triangles a joint was told of. Its
  // place must be the one it gets when all others, moved, were static from the start.
  constexpr Index Size = 12;
  Mesh mesh = ChamferedBox(Size, 0.3);
  const std::vector<Vec3> truth = Box(Size, Size, Size).Points;
  for (Vec3& p : mesh.Points)
  {
    const Vec3 fromCentre = p - Vec3::Constant(0.5 * Size);
    p -= 0.0005 * fromCentre.squaredNorm() * fromCentre;
  }
  const Connectivity connectivity(mesh);
  const Recovered recovered(mesh, 0.9);
  int joints = 0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    const bool isCorner = (truth[v].array() == 0.0 || truth[v].array() == Size).all();
    if (!isCorner || recovered.TheSkeleton.Roles[v] != SkeletonRole::Joint)
    {
      continue;
    }
    ++joints;
    Mesh others = mesh;
    others.Points = recovered.Points;
    others.Points[v] = mesh.Points[v];
    std::vector<int> rounds(mesh.Points.size(), NeverSharp);
    rounds[v] = 1;
    const std::vector<Vec3> points =
      SharpenedPoints(others, connectivity, rounds, TraceSkeleton(others, connectivity, rounds),
        0.9, AverageEdgeLength(mesh, connectivity), Monitor());
    EXPECT_LE((points[v] - recovered.Points[v]).norm(), 1e-9) << truth[v].transpose();
  }
  EXPECT_EQ(joints, 8);
}

TEST(Sharpening, DoesNotDependOnTheOrderOfStorage)
{
  const Mesh mesh = ChamferedBox(8, 0.3);
  Mesh reversed;
  const Index last = mesh.VertexCount() - 1;
  reversed.Points.assign(mesh.Points.rbegin(), mesh.Points.rend());
  for (auto t = mesh.Triangles.rbegin(); t != mesh.Triangles.rend(); ++t)
  {
    reversed.Triangles.push_back({ last - (*t)[0], last - (*t)[1], last - (*t)[2] });
  }
  // The same rounds for both: thinning may break ties by number, moving may not.
  const Connectivity connectivity(mesh);
  const Connectivity reversedConnectivity(reversed);
  const double edge = AverageEdgeLength(mesh, connectivity);
  const Recovered original(mesh, 0.9);
  const std::vector<int> rounds(original.Rounds.rbegin(), original.Rounds.rend());
  const std::vector<Vec3> points = SharpenedPoints(reversed, reversedConnectivity, rounds,
    TraceSkeleton(reversed, reversedConnectivity, rounds), 0.9, edge, Monitor());
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    // Sums run in another order: a few roundings.
    EXPECT_LE((points[last - v] - original.Points[v]).norm(), 1e-12);
  }
}

TEST(Sharpening, GivesNothingWhenStopped)
{
  const Mesh mesh = ChamferedBox(8, 0.3);
  const Connectivity connectivity(mesh);
  const Recovered whole(mesh, 0.9);
  for (int stopAt = 1; stopAt <= 3; ++stopAt)
  {
    int reports = 0;
    const Monitor monitor([&](double) { return ++reports < stopAt; });
    EXPECT_TRUE(
      SharpenedPoints(mesh, connectivity, whole.Rounds, whole.TheSkeleton, 0.9, 1.0, monitor)
        .empty());
  }
}
