// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Features.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
std::vector<Index> Ids(const Mesh& mesh, double angle = 30.0)
{
  const Connectivity connectivity(mesh);
  return FindSurfaces(mesh, connectivity, FeaturesAbove(mesh, angle)).Ids;
}
}

TEST(Surfaces, ASmoothMeshIsOne)
{
  const Mesh mesh = Torus(4.0, 1.0, 40, 20);
  EXPECT_EQ(Ids(mesh), std::vector<Index>(mesh.Triangles.size(), 0));
}

TEST(Surfaces, OfABoxAreItsFacesTheLargestFirst)
{
  const Mesh mesh = Box(5, 3, 2); // faces of 6 (at x), 10 (at y) and 15 (at z), stored so
  const std::vector<Index> ids = Ids(mesh);
  const std::vector<Vec3> normals = UnitNormals(mesh, 1.0);
  const std::array<std::array<Index, 2>, 3> expected = { { { 4, 5 }, { 2, 3 }, { 0, 1 } } };
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    int axis = 0;
    normals[t].cwiseAbs().maxCoeff(&axis);
    // Of two equal faces the one with the lower triangle has the lower number: the near one here.
    EXPECT_EQ(ids[t], expected[axis][normals[t][axis] > 0.0 ? 1 : 0]);
  }
}

TEST(Surfaces, AreBoundedByFeaturesOfTheGivenAngleOnly)
{
  const Mesh mesh = Fold(3, 5, 40.0);
  const auto faces = [&](double angle)
  {
    const std::vector<Index> ids = Ids(mesh, angle);
    return 1 + *std::max_element(ids.begin(), ids.end());
  };
  EXPECT_EQ(faces(30.0), 2);
  EXPECT_EQ(faces(50.0), 1);
}

TEST(Surfaces, AFeatureThatEndsDividesNothing)
{
  // A fold that runs out into a plane half way: one can walk round its end.
  Mesh mesh = Fold(4, 12, 60.0);
  const std::vector<Vec3> flat = Fold(4, 12, 0.0).Points;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    const double share = std::min(1.0, mesh.Points[v].y() / 8.0);
    mesh.Points[v] += share * (flat[v] - mesh.Points[v]);
  }
  ASSERT_FALSE(FeaturesAbove(mesh, 30.0).empty());
  EXPECT_EQ(Ids(mesh), std::vector<Index>(mesh.Triangles.size(), 0));
}

TEST(Surfaces, PartsThatDoNotTouchAreDifferentOnes)
{
  Mesh mesh = FlatGrid(2, 2);
  const std::size_t first = mesh.Triangles.size();
  Append(mesh, FlatGrid(3, 3));
  const std::vector<Index> ids = Ids(mesh);
  EXPECT_EQ(ids.front(), 1) << "the smaller one";
  EXPECT_EQ(ids[first], 0);
}

TEST(Surfaces, AreMeasured)
{
  const FeatureMesh box(Box(5, 3, 2));
  const std::vector<double> areas = { 15.0, 15.0, 10.0, 10.0, 6.0, 6.0 };
  ASSERT_EQ(box.Faces.Measures.size(), areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(box.Faces.Measures[i].Area, areas[i]);
    EXPECT_EQ(box.Faces.Measures[i].Triangles, static_cast<Index>(2.0 * areas[i]));
    EXPECT_EQ(box.Faces.Measures[i].BoundaryLoops, 1);
  }
}

TEST(Surfaces, CountTheLoopsAroundThem)
{
  EXPECT_EQ(FeatureMesh(Torus(4.0, 1.0, 40, 20)).Faces.Measures[0].BoundaryLoops, 0);
  EXPECT_EQ(FeatureMesh(FlatGrid(3, 3)).Faces.Measures[0].BoundaryLoops, 1);
  EXPECT_EQ(FeatureMesh(Tube(2.0, 40, 3, 1.0)).Faces.Measures[0].BoundaryLoops, 2);
  // Also where the boundary is no feature; and a feature that divides nothing bounds nothing.
  const Mesh fading = FadingFold(4, 12, 60.0, 8.0);
  const Connectivity connectivity(fading);
  const std::vector<FeatureEdge> features = FeaturesAbove(fading, 30.0);
  Surfaces faces = FindSurfaces(fading, connectivity, features);
  CountLoops(fading, connectivity, features, faces);
  ASSERT_EQ(faces.Measures.size(), 1u);
  EXPECT_EQ(faces.Measures[0].BoundaryLoops, 1);
}

TEST(Surfaces, OfWingsOnANonManifoldEdgeAreTheWings)
{
  EXPECT_EQ(FeatureMesh(Wings(5)).Faces.Measures.size(), 5u);
}

TEST(Surfaces, JoinedAreThoseFoundWithoutWhatDividedThem)
{
  const Mesh box = Box(5, 3, 2);
  const Connectivity connectivity(box);
  const std::vector<FeatureEdge> all = FeaturesAbove(box, 30.0);
  for (const std::size_t every : { 1, 7, 40, 1000 })
  {
    std::vector<FeatureEdge> kept;
    std::vector<FeatureEdge> dropped;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      (i % every == every - 1 ? dropped : kept).push_back(all[i]);
    }
    Surfaces joined = FindSurfaces(box, connectivity, all);
    JoinSurfaces(box, connectivity, dropped, joined);
    const Surfaces expected = FindSurfaces(box, connectivity, kept);
    EXPECT_EQ(joined.Ids, expected.Ids) << "every " << every << "th edge";
    ASSERT_EQ(joined.Measures.size(), expected.Measures.size());
    for (std::size_t i = 0; i < expected.Measures.size(); ++i)
    {
      EXPECT_EQ(joined.Measures[i].Area, expected.Measures[i].Area); // to the bit
      EXPECT_EQ(joined.Measures[i].Triangles, expected.Measures[i].Triangles);
      EXPECT_EQ(joined.Measures[i].First, expected.Measures[i].First);
    }
  }
}
