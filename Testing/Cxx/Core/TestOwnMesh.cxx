// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/OwnMesh.h"
#include "Core/EdgeLengths.h"
#include "Meshes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace arris;
using namespace arris::testing;

namespace
{
/// A chest: no axis is as long as another, and each has an end that the other is not like.
Mesh Chest()
{
  Mesh chest = Box(3, 5, 8);
  for (Vec3& p : chest.Points)
  {
    p += Vec3(0.03 * p.y() * p.y(), 0.02 * p.z() * p.z(), 0.05 * p.x() * p.x());
  }
  return chest;
}

const Eigen::Matrix3d Turn =
  Eigen::AngleAxisd(1.1, Vec3(3.0, -1.0, 2.0).normalized()).toRotationMatrix();

/// p -> 0.01 turn p + (5, -7, 9); turned inside out where that mirrors, as a mirrored part is.
Mesh Moved(Mesh mesh, const Eigen::Matrix3d& turn)
{
  for (Vec3& p : mesh.Points)
  {
    p = 0.01 * (turn * p) + Vec3(5.0, -7.0, 9.0);
  }
  for (Triangle& t : mesh.Triangles)
  {
    if (turn.determinant() < 0.0)
    {
      std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

/// The mesh with its points, cells and corners shuffled, and the new number of each vertex.
Mesh Shuffled(const Mesh& mesh, std::vector<Index>& place)
{
  std::mt19937 random(3);
  place.resize(mesh.Points.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  Mesh shuffled = mesh;
  for (std::size_t v = 0; v < place.size(); ++v)
  {
    shuffled.Points[place[v]] = mesh.Points[v];
  }
  for (Triangle& t : shuffled.Triangles)
  {
    t = { place[t[1]], place[t[2]], place[t[0]] };
  }
  std::shuffle(shuffled.Triangles.begin(), shuffled.Triangles.end(), random);
  return shuffled;
}

OwnMesh Own(const Mesh& mesh)
{
  return { mesh, Connectivity(mesh) };
}

/// A result as the method gives it: nothing found, nothing moved.
RobustResult Quiet(const OwnMesh& own)
{
  const std::size_t count = own.TheMesh.Points.size();
  RobustResult result;
  result.WindowRadii.resize(count);
  result.NormalDifferences.resize(count);
  result.Jumps.resize(count);
  result.Region.resize(count);
  result.Rounds.resize(count);
  result.Roles.resize(count);
  result.Outcomes.resize(count);
  result.Points = own.TheMesh.Points;
  return result;
}

void ExpectSame(const Rows& a, const Rows& b)
{
  EXPECT_EQ(a.Offsets, b.Offsets);
  EXPECT_EQ(a.Values, b.Values);
}

void ExpectSameHoweverStored(const Mesh& mesh)
{
  std::vector<Index> place;
  const Mesh other = Shuffled(mesh, place);
  const OwnMesh one = Own(mesh), two = Own(other);
  EXPECT_EQ(one.TheMesh.Points, two.TheMesh.Points);
  EXPECT_EQ(one.TheMesh.Triangles, two.TheMesh.Triangles);
}
}

TEST(OwnMesh, IsTheSameHoweverStored)
{
  ExpectSameHoweverStored(Chest());
}

TEST(OwnMesh, IsTheSameWhereSeveralVerticesAreAtOnePoint)
{
  Mesh mesh = Chest();
  const Vec3 at = mesh.Points[mesh.Triangles[7][0]];
  mesh.Points[mesh.Triangles[7][1]] = at;
  mesh.Points[mesh.Triangles[7][2]] = at;
  ExpectSameHoweverStored(mesh);
}

TEST(OwnMesh, IsTheSameElsewhereTurnedMirroredAndInAnotherUnit)
{
  const Mesh mesh = Chest();
  const OwnMesh here = Own(mesh);
  const Eigen::Matrix3d mirror = Vec3(1.0, -1.0, 1.0).asDiagonal();
  for (const Eigen::Matrix3d& turn : { Turn, Eigen::Matrix3d(mirror * Turn) })
  {
    const Mesh moved = Moved(mesh, turn);
    const OwnMesh there = Own(moved);
    EXPECT_EQ(here.TheMesh.Triangles, there.TheMesh.Triangles);
    int others = 0;
    for (std::size_t v = 0; v < mesh.Points.size(); ++v)
    {
      const Vec3 apart = here.TheMesh.Points[v] - there.TheMesh.Points[v];
      EXPECT_LE(apart.cwiseAbs().maxCoeff(), std::ldexp(1.0, -28)); // the next point of the grid
      others += apart.isZero(0.0) ? 0 : 1;
    }
    // Rounding of some 1e-14 edges beside a grid of 4e-9: one in a hundred thousand coordinates.
    EXPECT_EQ(others, 0);
  }
}

TEST(OwnMesh, HasEdgesOfMeanLengthOneAndFacesOutwards)
{
  const Mesh mesh = Moved(Chest(), Eigen::Matrix3d(-Turn));
  const OwnMesh own = Own(mesh);
  EXPECT_NEAR(GeometricMeanEdgeLength(own.TheMesh, own.TheConnectivity), 1.0, 1e-8);
  double volume = 0.0;
  for (Index t = 0; t < own.TheMesh.TriangleCount(); ++t)
  {
    const Corners corners(own.TheMesh, t);
    volume += corners.A.dot(corners.B.cross(corners.C)) / 6.0;
  }
  EXPECT_GT(volume, 0.0);
}

TEST(OwnMesh, HasTheConnectivityOfItsTriangles)
{
  Mesh mesh = Chest();
  mesh.Triangles.resize(mesh.Triangles.size() - 20); // open
  const OwnMesh own = Own(mesh);
  const Connectivity known(own.TheMesh);
  ExpectSame(own.TheConnectivity.TrianglesOfVertex, known.TrianglesOfVertex);
  ExpectSame(own.TheConnectivity.NeighborsOfVertex, known.NeighborsOfVertex);
  EXPECT_EQ(own.TheConnectivity.AcrossEdge, known.AcrossEdge);
  EXPECT_EQ(own.TheConnectivity.OnBoundary, known.OnBoundary);
}

TEST(OwnOrder, TrianglesKeepTheirPatches)
{
  Mesh mesh = Chest();
  const std::vector<Triangle> before = mesh.Triangles;
  Connectivity connectivity(mesh);
  connectivity.Common.assign(mesh.Points.size(), 0);
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    connectivity.PatchOf.push_back(t % 3 == 0 ? 5 : 2);
    connectivity.Common[mesh.Triangles[t][0]] |= t % 3 == 0 ? 1 : 0;
  }
  const OwnOrder order = PutInOwnOrder(mesh, connectivity);
  const Connectivity now = Renumbered(connectivity, before, order, mesh.Triangles);
  const Index five = connectivity.PatchOf[order.Triangles[0]] == 5 ? 0 : 1; // by which comes first
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    EXPECT_EQ(now.PatchOf[t], connectivity.PatchOf[order.Triangles[t]] == 5 ? five : 1 - five);
  }
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    EXPECT_EQ(now.Common[v], connectivity.Common[order.Vertices[v]]);
  }
}

TEST(OwnMesh, CubesKeepTheAxesOfTheCoordinates)
{
  // The moments of a cube tell no axes: rounding would turn it anyhow.
  const Mesh cube = Box(4, 4, 4);
  const OwnMesh own = Own(cube);
  const double side = 4.0 / GeometricMeanEdgeLength(cube, Connectivity(cube));
  for (const Vec3& p : own.TheMesh.Points)
  {
    EXPECT_NEAR(p.cwiseAbs().maxCoeff(), 0.5 * side, 1e-8) << p.transpose();
  }
}

TEST(OwnMesh, OfAPartBesideAnEndlessTriangleKeepsTheCoordinates)
{
  Mesh mesh = Chest();
  const Index first = mesh.VertexCount();
  mesh.Points.insert(
    mesh.Points.end(), { Vec3(1e12, 0.0, 0.0), Vec3(0.0, 1e12, 0.0), Vec3(0.0, 0.0, 1e12) });
  mesh.Triangles.push_back({ first, first + 1, first + 2 });
  std::vector<Vec3> given = mesh.Points, own = Own(mesh).TheMesh.Points;
  for (std::vector<Vec3>* points : { &given, &own })
  {
    std::sort(points->begin(), points->end(),
      [](const Vec3& a, const Vec3& b)
      { return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end()); });
  }
  EXPECT_EQ(given, own);
}

TEST(OwnMesh, OfAPartOnALargePlateKeepsItsDetails)
{
  Mesh mesh = Chest();
  const Index first = mesh.VertexCount();
  mesh.Points.insert(
    mesh.Points.end(), { Vec3(-1e5, 0.0, 0.0), Vec3(1e5, 1e5, 0.0), Vec3(1e5, -1e5, 0.0) });
  mesh.Triangles.push_back({ first, first + 1, first + 2 });
  const OwnMesh own = Own(mesh);
  const double edge = GeometricMeanEdgeLength(mesh, Connectivity(mesh));
  EXPECT_LT(edge, 2.0) << "an edge of the part";
  EXPECT_NEAR(LongestEdge(own.TheMesh) * edge, LongestEdge(mesh), 1e-8 * LongestEdge(mesh));
}

TEST(OwnMesh, GivesEachVertexItsOwn)
{
  const Mesh mesh = Moved(Chest(), Turn);
  const OwnMesh own = Own(mesh);
  RobustResult result = Quiet(own);
  const double edge = GeometricMeanEdgeLength(mesh, Connectivity(mesh));
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    result.WindowRadii[v] = own.TheMesh.Points[v].norm();
    result.Region[v] = v == 5;
  }
  result.Points[5] += Vec3(0.25, 0.0, 0.0);
  const Vec3 moved = result.Points[5];
  const RobustResult back = own.Back(result);
  const Vec3 middle = std::accumulate(mesh.Points.begin(), mesh.Points.end(), Vec3(Vec3::Zero())) /
    static_cast<double>(mesh.Points.size());
  int moves = 0;
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    EXPECT_NEAR(back.WindowRadii[v], (mesh.Points[v] - middle).norm(), 1e-8 * edge);
    EXPECT_EQ(back.Region[v] != 0, back.Points[v] != mesh.Points[v]);
    if (back.Region[v])
    {
      ++moves;
      EXPECT_NEAR((back.Points[v] - mesh.Points[v]).norm(), 0.25 * edge, 1e-8 * edge);
      EXPECT_NEAR((back.Points[v] - middle).norm(), moved.norm() * edge, 1e-8 * edge);
    }
  }
  EXPECT_EQ(moves, 1);
}

TEST(OwnMesh, GivesTrianglesBackAsTheyWere)
{
  for (const Eigen::Matrix3d& turn : { Turn, Eigen::Matrix3d(-Turn) })
  {
    const Mesh mesh = Moved(Chest(), turn);
    const OwnMesh own = Own(mesh);
    RobustResult result = Quiet(own);
    result.Triangles = own.TheMesh.Triangles;
    EXPECT_EQ(own.Back(result).Triangles, mesh.Triangles);

    // One more corner of the first triangle's neighbour, as after a flip.
    Triangle& changed = result.Triangles[0];
    const Index beyond = own.TheConnectivity.AcrossEdge[0][1];
    for (Index v : own.TheMesh.Triangles[beyond])
    {
      changed[0] = v != changed[1] && v != changed[2] ? v : changed[0];
    }
    const std::vector<Triangle> back = own.Back(result).Triangles;
    int others = 0;
    for (std::size_t t = 0; t < back.size(); ++t)
    {
      others += back[t] != mesh.Triangles[t] ? 1 : 0;
    }
    EXPECT_EQ(others, 1);
  }
}

TEST(OwnMesh, TakesWindowsInItsUnit)
{
  const Mesh mesh = Moved(Chest(), Turn);
  const OwnMesh own = Own(mesh);
  RobustParameters parameters;
  parameters.WindowRadius = 2.0 * GeometricMeanEdgeLength(mesh, Connectivity(mesh));
  EXPECT_DOUBLE_EQ(own.Into(parameters).WindowRadius, 2.0);
}

TEST(OwnMesh, OfNothingIsNothing)
{
  const Mesh nothing;
  EXPECT_TRUE(Own(nothing).TheMesh.Points.empty());
  Mesh points;
  points.Points = { Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(0, 0, 0) };
  const OwnMesh own = Own(points);
  EXPECT_EQ(own.TheMesh.Points.size(), 3u);
  EXPECT_EQ(own.Back(Quiet(own)).Points, points.Points);
}
