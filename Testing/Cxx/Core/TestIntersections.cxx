// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Intersections.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <tuple>

using namespace arris;

namespace
{
using Pairs = std::vector<std::array<Index, 2>>;
const Pairs OnePair = { { 0, 1 } };

std::vector<Index> All(const Mesh& mesh)
{
  std::vector<Index> all(mesh.Triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Pairs Find(const Mesh& mesh, const std::vector<Index>& triangles)
{
  return FindIntersections(mesh, triangles);
}

Pairs Find(const Mesh& mesh)
{
  return Find(mesh, All(mesh));
}

/// The mesh turned at random, scaled, and shifted.
Mesh Moved(Mesh mesh, double scale, double shift)
{
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  for (Vec3& point : mesh.Points)
  {
    point = scale * (turn * point) + Vec3(shift, -0.7 * shift, 0.3 * shift);
  }
  return mesh;
}

/// What is found in the mesh, and must be found wherever it is, however large, from either triangle
/// and whatever corner comes first.
Pairs FindAnyhow(const Mesh& mesh)
{
  Pairs found = Find(mesh);
  for (const double scale : { 1e-3, 1.0, 1e3 })
  {
    for (const double shift : { 0.0, 1e3 })
    {
      EXPECT_EQ(Find(Moved(mesh, scale, shift)), found) << scale << ' ' << shift;
    }
  }
  if (mesh.TriangleCount() == 2)
  {
    for (int turns = 0; turns < 36; ++turns)
    {
      Mesh turned = mesh;
      Triangle& first = turned.Triangles[0];
      Triangle& second = turned.Triangles[1];
      std::rotate(first.begin(), first.begin() + turns % 3, first.end());
      std::rotate(second.begin(), second.begin() + turns / 3 % 3, second.end());
      if (turns / 9 % 2)
      {
        std::swap(first[0], first[1]);
      }
      if (turns / 18)
      {
        std::swap(first, second);
      }
      EXPECT_EQ(Find(turned), found) << turns;
      EXPECT_EQ(Find(turned, { 0 }), found) << turns;
      EXPECT_EQ(Find(turned, { 1 }), found) << turns;
    }
  }
  return found;
}

Mesh TwoTriangles(const std::array<Vec3, 3>& one, const std::array<Vec3, 3>& other)
{
  Mesh mesh;
  mesh.Points.assign(one.begin(), one.end());
  mesh.Points.insert(mesh.Points.end(), other.begin(), other.end());
  mesh.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  return mesh;
}

/// An octahedron with each face split in four, `times` over, and blown up to a sphere.
void AddSphere(Mesh& mesh, int times, const Vec3& center, double radius)
{
  std::vector<Vec3> points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  std::vector<Triangle> triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 },
    { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  for (int i = 0; i < times; ++i)
  {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b)
    {
      const auto [at, isNew] = middles.insert({ std::minmax(a, b), Index(points.size()) });
      if (isNew)
      {
        points.push_back((points[a] + points[b]).normalized());
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles)
    {
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
    }
    triangles = finer;
  }
  const Index first = mesh.VertexCount();
  for (const Vec3& point : points)
  {
    mesh.Points.emplace_back(center + radius * point);
  }
  for (const auto& [a, b, c] : triangles)
  {
    mesh.Triangles.push_back({ a + first, b + first, c + first });
  }
}

Mesh TwoSpheres(int times)
{
  Mesh mesh;
  AddSphere(mesh, times, Vec3::Zero(), 1.0);
  AddSphere(mesh, times, { 0.71, 0.33, 0.17 }, 0.9);
  return mesh;
}

/// Triangles of sizes that differ by 1000, thrown anywhere, every tenth vertex one that is there.
Mesh Mess(int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  Mesh mesh;
  for (int t = 0; t < count; ++t)
  {
    const Vec3 center = vector();
    const double size = std::pow(10.0, 1.5 * number(random) - 1.5);
    Triangle triangle;
    for (Index& vertex : triangle)
    {
      const Index existing = static_cast<Index>(0.5 * (number(random) + 1.0) * mesh.VertexCount());
      if (number(random) < -0.8 && existing < mesh.VertexCount() &&
        std::find(triangle.begin(), &vertex, existing) == &vertex)
      {
        vertex = existing;
        continue;
      }
      vertex = mesh.VertexCount();
      mesh.Points.emplace_back(center + size * vector());
    }
    mesh.Triangles.push_back(triangle);
  }
  return mesh;
}

/// Two triangles of a mesh, alone, with the vertices they share.
Mesh Excerpt(const Mesh& mesh, Index t1, Index t2)
{
  Mesh excerpt;
  std::vector<Index> vertices;
  for (const Index t : { t1, t2 })
  {
    Triangle triangle;
    for (int k = 0; k < 3; ++k)
    {
      const auto at = std::find(vertices.begin(), vertices.end(), mesh.Triangles[t][k]);
      triangle[k] = static_cast<Index>(at - vertices.begin());
      if (at == vertices.end())
      {
        vertices.push_back(mesh.Triangles[t][k]);
        excerpt.Points.push_back(mesh.Points[vertices.back()]);
      }
    }
    excerpt.Triangles.push_back(triangle);
  }
  return excerpt;
}

Pairs FindPairByPair(const Mesh& mesh)
{
  Pairs pairs;
  for (Index i = 0; i < mesh.TriangleCount(); ++i)
  {
    for (Index j = i + 1; j < mesh.TriangleCount(); ++j)
    {
      if (!FindIntersections(Excerpt(mesh, i, j), { 0 }).empty())
      {
        pairs.push_back({ i, j });
      }
    }
  }
  return pairs;
}

long double Volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  using Long = Eigen::Matrix<long double, 3, 1>;
  const Long o = a.cast<long double>();
  return (b.cast<long double>() - o)
    .cross(c.cast<long double>() - o)
    .dot(d.cast<long double>() - o);
}

/// An independent predicate, for triangles in general position that share at most one vertex: an
/// edge of one that does not end in a vertex of the other goes through it.
bool EdgeGoesThrough(const Mesh& mesh, const Triangle& edges, const Triangle& face)
{
  const auto isOfFace = [&](Index v)
  { return std::find(face.begin(), face.end(), v) != face.end(); };
  const Vec3& a = mesh.Points[face[0]];
  const Vec3& b = mesh.Points[face[1]];
  const Vec3& c = mesh.Points[face[2]];
  for (int k = 0; k < 3; ++k)
  {
    const Vec3& p = mesh.Points[edges[k]];
    const Vec3& q = mesh.Points[edges[Next(k)]];
    if (isOfFace(edges[k]) || isOfFace(edges[Next(k)]) ||
      (Volume(a, b, c, p) > 0) == (Volume(a, b, c, q) > 0))
    {
      continue;
    }
    const bool side = Volume(p, q, a, b) > 0;
    if ((Volume(p, q, b, c) > 0) == side && (Volume(p, q, c, a) > 0) == side)
    {
      return true;
    }
  }
  return false;
}

int Shared(const Triangle& one, const Triangle& other)
{
  return static_cast<int>(std::count_if(one.begin(), one.end(),
    [&](Index v) { return std::find(other.begin(), other.end(), v) != other.end(); }));
}

Pairs FindInGeneralPosition(const Mesh& mesh)
{
  Pairs pairs;
  for (Index i = 0; i < mesh.TriangleCount(); ++i)
  {
    for (Index j = i + 1; j < mesh.TriangleCount(); ++j)
    {
      const Triangle& one = mesh.Triangles[i];
      const Triangle& other = mesh.Triangles[j];
      if (Shared(one, other) < 2 &&
        (EdgeGoesThrough(mesh, one, other) || EdgeGoesThrough(mesh, other, one)))
      {
        pairs.push_back({ i, j });
      }
    }
  }
  return pairs;
}

/// The pairs with a triangle in the list.
Pairs Of(const Pairs& pairs, const std::vector<Index>& list)
{
  Pairs some;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(some),
    [&](const std::array<Index, 2>& pair)
    {
      return std::find(list.begin(), list.end(), pair[0]) != list.end() ||
        std::find(list.begin(), list.end(), pair[1]) != list.end();
    });
  return some;
}

const std::array<Vec3, 3> Floor = { Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0) };
}

TEST(Intersections, Crossing)
{
  // An edge goes through the floor; both triangles are through each other's edge; a corner is in
  // the floor, and the opposite edge beside it.
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(9, 9, 1) })), OnePair);
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(1, 2, 0.5) })), OnePair);
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(-1, 1, -1), Vec3(-1, 1, 1), Vec3(2, 1, 0) })), OnePair);
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(-1, 1, -1), Vec3(-1, 1, 1), Vec3(9, 1, 0) })), OnePair);
}

TEST(Intersections, CrossingOnlyInEdges)
{
  // The common segment ends on edges of both.
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(0, 1, -1), Vec3(0, 1, 1), Vec3(6, 1, 0) })), OnePair);
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(0, 1, -1), Vec3(0, 1, 1), Vec3(6, 1, -1) })), OnePair);
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(4, 4, 0) })), OnePair);
}

TEST(Intersections, Apart)
{
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(1, 1, 0.1), Vec3(1, 1, 1), Vec3(9, 9, 1) })), Pairs());
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(3, 3, -1), Vec3(3, 3, 1), Vec3(9, 9, 1) })), Pairs());
  // On both sides of each other's plane, but one after the other on the line.
  EXPECT_EQ(FindAnyhow(TwoTriangles(Floor, { Vec3(-1, 1, -1), Vec3(-1, 1, 1), Vec3(-2, 1, 0.5) })),
    Pairs());
}

TEST(Intersections, Touching)
{
  // A corner in the floor, on its edge, on its corner; an edge in the floor; edge on edge,
  // crosswise and along; the lone corner's segment ending where the other begins.
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(9, 9, 1) })), Pairs());
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(1, 0, 0), Vec3(1, 1, 1), Vec3(9, 9, 1) })), Pairs());
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(4, 0, 0), Vec3(1, 1, 1), Vec3(9, 9, 1) })), Pairs());
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 1) })), Pairs());
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(0, 1, -1), Vec3(0, 1, 1), Vec3(-3, 1, 0.5) })), Pairs());
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 0, 3) })), Pairs());
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(-3, 0, -1), Vec3(-3, 0, 1), Vec3(0, 0, 0) })), Pairs());
}

TEST(Intersections, TouchingWithinTolerance)
{
  for (const double deep : { 1e-11, 1e-12, 1e-13, 1e-14 })
  {
    EXPECT_EQ(
      Find(TwoTriangles(Floor, { Vec3(1, 1, -deep), Vec3(1, 2, 1), Vec3(3, 1, 1) })), Pairs());
    EXPECT_EQ(Find(TwoTriangles(Floor, { Vec3(deep, 1, -1), Vec3(deep, 1, 1), Vec3(-3, 1, 0.5) })),
      Pairs());
  }
  constexpr double through = 1e-8;
  EXPECT_EQ(
    Find(TwoTriangles(Floor, { Vec3(1, 1, -through), Vec3(1, 2, 1), Vec3(3, 1, 1) })), OnePair);
  EXPECT_EQ(
    Find(TwoTriangles(Floor, { Vec3(through, 1, -1), Vec3(through, 1, 1), Vec3(-3, 1, 0.5) })),
    OnePair);
}

TEST(Intersections, ParallelAndClose)
{
  for (const double gap : { 0.0, 1e-14, 1e-10, 1e-6 })
  {
    EXPECT_EQ(
      Find(TwoTriangles(Floor, { Vec3(0, 0, gap), Vec3(4, 0, gap), Vec3(0, 4, gap) })), Pairs());
    EXPECT_EQ(
      Find(TwoTriangles(Floor, { Vec3(1, 1, gap), Vec3(5, 1, gap), Vec3(1, -3, gap) })), Pairs());
  }
}

TEST(Intersections, SharedVertex)
{
  Mesh mesh = TwoTriangles(Floor, { Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(1, 1, 0) });
  mesh.Triangles[1] = { 0, 3, 4 }; // stands on the floor's corner; its far edge goes through
  EXPECT_EQ(FindAnyhow(mesh), OnePair);
  mesh.Points[3] = { 5, 5, -1 }; // now the floor's far edge goes through it
  mesh.Points[4] = { 5, 5, 1 };
  EXPECT_EQ(FindAnyhow(mesh), OnePair);
  mesh.Points[3] = { 2, 2, -1 }; // now the two far edges meet
  mesh.Points[4] = { 2, 2, 1 };
  EXPECT_EQ(FindAnyhow(mesh), OnePair);
  mesh.Points[3] = { -1, -1, -1 }; // leaves the vertex to the other side
  mesh.Points[4] = { -1, -1, 1 };
  EXPECT_EQ(FindAnyhow(mesh), Pairs());
  mesh.Points[3] = { 1, 1, 1 }; // above
  mesh.Points[4] = { 1, 2, 1 };
  EXPECT_EQ(FindAnyhow(mesh), Pairs());
  mesh.Points[3] = { 1, 1, 0 }; // along the floor, then up
  mesh.Points[4] = { 1, 2, 1 };
  EXPECT_EQ(FindAnyhow(mesh), Pairs());
  mesh.Points[3] = { 1, 0, -1 }; // along the floor's edge
  mesh.Points[4] = { 1, 0, 1 };
  EXPECT_EQ(FindAnyhow(mesh), Pairs());
  mesh.Points[3] = { 1, 0.01, -1 }; // just inside of it
  mesh.Points[4] = { 1, 0.01, 1 };
  EXPECT_EQ(FindAnyhow(mesh), OnePair);
}

TEST(Intersections, SharedEdge)
{
  const auto fold = [](double degrees)
  {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    Mesh mesh;
    mesh.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 },
      { 1, 3 * std::cos(angle), 3 * std::sin(angle) } };
    mesh.Triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
    return mesh;
  };
  EXPECT_EQ(FindAnyhow(fold(0.0)), OnePair);
  for (const double degrees : { 0.01, 1.0, 90.0, 179.0, 180.0, 181.0, 359.0 })
  {
    EXPECT_EQ(FindAnyhow(fold(degrees)), Pairs()) << degrees;
  }
}

TEST(Intersections, SharedTriangle)
{
  Mesh mesh;
  mesh.Points.assign(Floor.begin(), Floor.end());
  mesh.Triangles = { { 0, 1, 2 }, { 1, 0, 2 } };
  EXPECT_EQ(FindAnyhow(mesh), OnePair);
}

TEST(Intersections, NoArea)
{
  // A line through the floor, and a point in it.
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(1, 1, 0) })), Pairs());
  EXPECT_EQ(
    FindAnyhow(TwoTriangles(Floor, { Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 0) })), Pairs());
  Mesh mesh = TwoTriangles(Floor, { Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(5, 0, 0) });
  mesh.Triangles[1] = { 0, 1, 4 }; // flat, on the floor's edge
  EXPECT_EQ(FindAnyhow(mesh), Pairs());
}

TEST(Intersections, NothingAndNotNumbers)
{
  EXPECT_EQ(Find(Mesh()), Pairs());
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { nan, infinity, -infinity })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Mesh mesh = TwoTriangles(Floor, { Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(9, 9, 1) });
      EXPECT_EQ(Find(mesh, {}), Pairs());
      mesh.Points[5][axis] = bad;
      for (const std::vector<Index>& list : { std::vector<Index>{ 0 }, { 1 }, { 0, 1 } })
      {
        Find(mesh, list); // must not fail, whatever it says
      }
    }
  }
}

TEST(Intersections, SphereHasNone)
{
  Mesh mesh;
  AddSphere(mesh, 5, { 0.1, 0.2, 0.3 }, 1.0);
  EXPECT_EQ(FindAnyhow(mesh), Pairs());
}

TEST(Intersections, TwoSpheresAsPairByPair)
{
  const Mesh mesh = TwoSpheres(3);
  const Pairs found = FindAnyhow(mesh);
  EXPECT_GT(found.size(), 50u);
  EXPECT_EQ(found, FindInGeneralPosition(mesh));
  EXPECT_EQ(found, FindPairByPair(mesh));
  for (const auto& [one, other] : found)
  {
    EXPECT_LT(one, mesh.TriangleCount() / 2);
    EXPECT_GE(other, mesh.TriangleCount() / 2);
  }
}

TEST(Intersections, SpheresThroughEachOthersEdges)
{
  // Two octahedral spheres, shifted along a symmetry plane of both: edges meet edges.
  Mesh mesh;
  AddSphere(mesh, 3, Vec3::Zero(), 1.0);
  AddSphere(mesh, 3, { 1.0, 0.0, 0.0 }, 1.0);
  const Pairs found = FindAnyhow(mesh);
  EXPECT_EQ(found, FindPairByPair(mesh));
  // They mirror each other in the plane x = 1/2. A triangle that this plane cuts has an image that
  // it meets along the whole cut, from edge to edge.
  const double tiny = 1e-6;
  const Index half = mesh.TriangleCount() / 2;
  for (Index t = 0; t < half; ++t)
  {
    int left = 0;
    int right = 0;
    Vec3 image = Vec3::Zero();
    for (const Index v : mesh.Triangles[t])
    {
      left += mesh.Points[v][0] < 0.5 - tiny;
      right += mesh.Points[v][0] > 0.5 + tiny;
      image += Vec3(1.0 - mesh.Points[v][0], mesh.Points[v][1], mesh.Points[v][2]) / 3.0;
    }
    if (left > 0 && right > 0)
    {
      Index mirrored = half;
      const auto toImage = [&](Index other)
      {
        const auto& [a, b, c] = mesh.Triangles[other];
        return ((mesh.Points[a] + mesh.Points[b] + mesh.Points[c]) / 3.0 - image).norm();
      };
      for (Index other = half; other < mesh.TriangleCount(); ++other)
      {
        mirrored = toImage(other) < toImage(mirrored) ? other : mirrored;
      }
      ASSERT_LT(toImage(mirrored), tiny);
      EXPECT_TRUE(
        std::binary_search(found.begin(), found.end(), std::array<Index, 2>{ t, mirrored }));
    }
  }
}

TEST(Intersections, MessAsPairByPair)
{
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    const Mesh mesh = Mess(600, seed);
    const Pairs expected = FindInGeneralPosition(mesh);
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(FindAnyhow(mesh), expected);
    for (const int step : { 2, 7, 50, 599 })
    {
      std::vector<Index> list;
      for (Index t = mesh.TriangleCount() - 1; t >= 0; t -= step)
      {
        list.push_back(t);
        list.push_back(t); // twice is no matter
      }
      EXPECT_EQ(Find(mesh, list), Of(expected, list));
    }
  }
}

TEST(Intersections, Permuted)
{
  const Mesh mesh = Mess(600, 7);
  const Pairs expected = Find(mesh);
  std::vector<Index> order = All(mesh);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  Mesh permuted = mesh;
  for (std::size_t t = 0; t < order.size(); ++t)
  {
    permuted.Triangles[t] = mesh.Triangles[order[t]];
  }
  Pairs found = Find(permuted);
  for (auto& [one, other] : found)
  {
    const auto both = std::minmax(order[one], order[other]);
    std::tie(one, other) = std::pair<Index, Index>(both);
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}

TEST(Intersections, HugeTriangleThroughTinyOnes)
{
  Mesh mesh;
  AddSphere(mesh, 4, Vec3::Zero(), 1.0);
  const Index huge = mesh.TriangleCount();
  const Index first = mesh.VertexCount();
  mesh.Points.insert(
    mesh.Points.end(), { { -1e7, -1e7, 0.013 }, { 1e7, -1e7, 0.017 }, { 0.0, 1e7, 0.011 } });
  mesh.Triangles.push_back({ first, first + 1, first + 2 });
  const Pairs found = Find(mesh);
  EXPECT_GT(found.size(), 50u);
  EXPECT_EQ(found, Find(mesh, { huge }));
  std::vector<Index> sphere = All(mesh);
  sphere.pop_back();
  EXPECT_EQ(found, Find(mesh, sphere));
}
