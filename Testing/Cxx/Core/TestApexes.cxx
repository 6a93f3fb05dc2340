// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Labelling.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
/// Rings of vertices one unit apart around vertex 0; vertex 1 + (r - 1) * sectors + i is on ring r.
template <typename Height>
Mesh Rings(Index rings, Index sectors, Height&& height)
{
  Mesh mesh;
  mesh.Points.emplace_back(0.0, 0.0, height(0.0));
  for (Index r = 1; r <= rings; ++r)
  {
    for (Index i = 0; i < sectors; ++i)
    {
      const double angle = 2.0 * Pi * i / sectors;
      mesh.Points.emplace_back(r * std::cos(angle), r * std::sin(angle), height(r));
    }
  }
  for (Index i = 0; i < sectors; ++i)
  {
    const Index next = (i + 1) % sectors;
    mesh.Triangles.push_back({ 0, 1 + i, 1 + next });
    for (Index r = 1; r < rings; ++r)
    {
      const Index inner = 1 + (r - 1) * sectors;
      const Index outer = inner + sectors;
      AddQuad(mesh, inner + i, outer + i, outer + next, inner + next);
    }
  }
  return mesh;
}

/// A cone with its tip at the origin, which the vertex that should be there has been cut off from.
Mesh BluntCone(Index rings, Index sectors, double slope)
{
  return Rings(rings, sectors, [slope](double r) { return -slope * std::max(r, 0.7); });
}

/// The tips that there are if these vertices are damaged, and all is rounded so far (0 to 1).
std::vector<Apex> Find(const Mesh& mesh, const std::vector<Index>& damaged, double rounding = 0.0)
{
  const Connectivity connectivity(mesh);
  const Faces faces(mesh, connectivity, 1.0);
  const std::vector<double> scales(mesh.Points.size(), 1.0);
  const std::vector<double> flatness(mesh.Points.size(), 0.0);
  Flags region(mesh.Points.size(), 0);
  for (const Index v : damaged)
  {
    region[v] = 1;
  }
  return FindApexes({ mesh, connectivity, faces, scales, flatness, rounding, {}, nullptr }, region);
}

std::vector<Index> FirstVertices(Index count)
{
  std::vector<Index> vertices;
  for (Index v = 0; v < count; ++v)
  {
    vertices.push_back(v);
  }
  return vertices;
}

constexpr Index Sectors = 12;
const std::vector<Index> TipAndItsRing = FirstVertices(1 + Sectors);
}

TEST(Apexes, IsWhereThePlanesAroundMeet)
{
  const auto apexes = Find(BluntCone(6, Sectors, 1.0), TipAndItsRing);
  ASSERT_EQ(apexes.size(), 1u);
  EXPECT_LT(apexes[0].Tip.norm(), 1e-9); // all of its planes go through the origin
  EXPECT_EQ(apexes[0].Vertex, 0);
  EXPECT_EQ(apexes[0].Members, TipAndItsRing);
}

TEST(Apexes, StayWhereTheyAreAroundTheVertexThatGoesToTheTip)
{
  const Mesh cone = BluntCone(6, Sectors, 1.0);
  const auto apexes = Find(cone, TipAndItsRing);
  ASSERT_EQ(apexes.size(), 1u);
  EXPECT_EQ(apexes[0].Places[0], apexes[0].Tip);
  for (std::size_t i = 1; i < apexes[0].Members.size(); ++i)
  {
    EXPECT_EQ(apexes[0].Places[i], cone.Points[apexes[0].Members[i]]);
  }
}

// A hyperboloid comes to a cone as a blurred cone does: by the distance to the tip.
TEST(Apexes, AreFoundThroughABlurAndAllPutOnTheCone)
{
  constexpr Index Damaged = 3; // rings
  const Mesh blurred = Rings(16, Sectors, [](double r) { return -std::sqrt(r * r + 1.0); });
  const auto apexes = Find(blurred, FirstVertices(1 + Damaged * Sectors), 1.0);
  ASSERT_EQ(apexes.size(), 1u);
  EXPECT_LT(apexes[0].Tip.norm(), 0.1);
  const auto offCone = [](const Vec3& point)
  { return std::abs(point.z() + std::hypot(point.x(), point.y())); };
  for (std::size_t i = 1; i < 1 + 2 * Sectors; ++i) // beyond, it fades
  {
    const Vec3& before = blurred.Points[apexes[0].Members[i]];
    EXPECT_LT(offCone(apexes[0].Places[i]), 0.4 * offCone(before)) << "vertex " << i;
  }
}

TEST(Apexes, HasALabelOfItsOwnAndNoSides)
{
  const Mesh cone = BluntCone(6, Sectors, 1.0);
  Labelling labelling;
  labelling.Labels.assign(cone.Points.size(), 0);
  labelling.SidesOf.assign(cone.Points.size(), NoIndex);
  for (const Index v : TipAndItsRing)
  {
    labelling.SidesOf[v] = static_cast<Index>(labelling.Sides.size());
    labelling.Sides.emplace_back(1);
  }
  labelling.FirstApexLabel = 5;
  LabelTips(Find(cone, TipAndItsRing), labelling);
  for (const Index v : TipAndItsRing)
  {
    EXPECT_EQ(labelling.Labels[v], 5);
    EXPECT_TRUE(labelling.Sides[labelling.SidesOf[v]].empty());
  }
  EXPECT_EQ(labelling.Labels.back(), 0) << "what is intact keeps its patch";
}

TEST(Apexes, IsNoneInADentOfANearlyFlatFace)
{
  EXPECT_TRUE(Find(BluntCone(6, Sectors, 0.2), TipAndItsRing).empty());
}

TEST(Apexes, IsNoneWhereThePlanesMissEachOther)
{
  const Mesh dome = Rings(6, Sectors, [](double r) { return -r * r / 10.0; });
  EXPECT_TRUE(Find(dome, TipAndItsRing).empty());
}

TEST(Apexes, IsNoneBesideAnotherPartOfTheRegion)
{
  std::vector<Index> damaged = TipAndItsRing;
  damaged.push_back(1 + 3 * Sectors); // on the fourth ring
  EXPECT_TRUE(Find(BluntCone(6, Sectors, 1.0), damaged).empty());
}

TEST(Apexes, IsNoneOnABoundary)
{
  EXPECT_TRUE(Find(BluntCone(6, Sectors, 1.0), { 1 + 5 * Sectors }).empty());
}

TEST(Apexes, IsNoneWhereTooLittleIsAround)
{
  EXPECT_TRUE(Find(BluntCone(2, 6, 1.0), { 0 }).empty());
}

TEST(Apexes, IsNoneInARegionThatIsLargerThanATips)
{
  constexpr Index TooMany = 17;
  const Mesh cone = BluntCone(TooMany + 5, Sectors, 1.0);
  EXPECT_TRUE(Find(cone, FirstVertices(1 + TooMany * Sectors)).empty());
}
