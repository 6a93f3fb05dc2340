// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Assembly/Assembly.h"

#include "Core/Assembly/PatchesApart.h"
#include "Core/ConnectedWindow.h"
#include "Core/SpatialWindow.h"
#include "Core/Thinning.h"
#include "Meshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr double Tolerance = 1e-9;

/// A mesh with what MakeAssembly makes of it.
struct Made
{
  Mesh TheMesh;
  Connectivity TheConnectivity;
  Assembly TheAssembly;

  explicit Made(const Mesh& mesh, const std::vector<Index>& ids = {})
    : TheMesh(mesh)
    , TheConnectivity(mesh)
    , TheAssembly(MakeAssembly(this->TheMesh, this->TheConnectivity, ids, Tolerance))
  {
  }
  const AssemblyFacts& Facts() const { return this->TheAssembly.Facts; }
};

/// Two flat squares beside each other along x = 4 and one that stands on that line. Vertices on the
/// line are shared or threefold.
Mesh ThreeSheets(bool shared)
{
  Mesh mesh = FlatGrid(4, 5);
  Mesh right = FlatGrid(4, 5);
  Mesh upright = FlatGrid(4, 5);
  for (Vec3& point : right.Points)
  {
    point.x() += 4.0;
  }
  for (Vec3& point : upright.Points)
  {
    point = Vec3(4.0, point.y(), point.x());
  }
  Append(mesh, right);
  Append(mesh, upright);
  if (shared)
  {
    const Made made(mesh);
    return made.TheMesh;
  }
  return mesh;
}

/// The sheet that a triangle of ThreeSheets belongs to.
std::vector<Index> SheetIds()
{
  std::vector<Index> ids;
  for (Index sheet = 0; sheet < 3; ++sheet)
  {
    ids.insert(ids.end(), FlatGrid(4, 5).Triangles.size(), sheet);
  }
  return ids;
}

/// A strip of `count` squares that comes back to its start after half a turn.
Mesh Moebius(Index count)
{
  Mesh mesh;
  for (Index i = 0; i < count; ++i)
  {
    const double u = 2.0 * Pi * i / count;
    for (const double s : { -1.0, 0.0, 1.0 })
    {
      const double r = 5.0 + s * std::cos(0.5 * u);
      mesh.Points.emplace_back(r * std::cos(u), r * std::sin(u), s * std::sin(0.5 * u));
    }
  }
  for (Index i = 0; i < count; ++i)
  {
    for (Index k = 0; k < 2; ++k)
    {
      const bool last = i + 1 == count;
      const Index a = 3 * i + k;
      AddQuad(mesh, a, last ? 2 - k : a + 3, last ? 1 - k : a + 4, a + 1);
    }
  }
  return mesh;
}

/// Whether all triangles run along their common edges in opposite directions.
bool IsWoundOneWay(const Made& made)
{
  const Mesh& mesh = made.TheMesh;
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index beyond = made.TheConnectivity.AcrossEdge[t][k];
      if (beyond != NoIndex)
      {
        const Triangle& other = mesh.Triangles[beyond];
        const int from = CornerOf(other, mesh.Triangles[t][Next(k)]);
        if (other[Next(from)] != mesh.Triangles[t][k])
        {
          return false;
        }
      }
    }
  }
  return true;
}
}

TEST(Assembly, AClosedMeshStaysAsItIs)
{
  const Mesh mesh = Torus(3.0, 1.0, 24, 12);
  const Made made(mesh);
  EXPECT_EQ(made.TheMesh.Triangles, mesh.Triangles);
  EXPECT_EQ(made.TheConnectivity.AcrossEdge, Connectivity(mesh).AcrossEdge);
  EXPECT_TRUE(made.TheAssembly.SameAs.empty());
  EXPECT_TRUE(made.TheConnectivity.PatchOf.empty());
  EXPECT_TRUE(made.TheConnectivity.Common.empty());
}

TEST(Assembly, AnOpenMeshKeepsItsConnectivity)
{
  const Mesh mesh = Tube(2.0, 12, 5, 4.0);
  const Made made(mesh);
  const Connectivity before(mesh);
  EXPECT_EQ(made.TheMesh.Triangles, mesh.Triangles);
  EXPECT_EQ(made.TheConnectivity.AcrossEdge, before.AcrossEdge);
  EXPECT_EQ(made.TheConnectivity.OnBoundary, before.OnBoundary);
  EXPECT_TRUE(made.TheConnectivity.PatchOf.empty());
  EXPECT_EQ(made.Facts().OpenEdges, 24);
  EXPECT_EQ(made.Facts().Patches, 1);
}

TEST(Assembly, ClosedPartsThatTouchWithoutIdsStayApart)
{
  Mesh mesh = Box(2, 2, 2);
  Mesh other = Box(2, 2, 2);
  for (Vec3& point : other.Points)
  {
    point.x() += 2.0;
  }
  Append(mesh, other);
  const Made made(mesh);
  EXPECT_EQ(made.TheMesh.Triangles, mesh.Triangles);
  EXPECT_TRUE(made.TheConnectivity.Common.empty());
}

TEST(Assembly, EdgesOfThreeTrianglesPartPatches)
{
  for (const bool shared : { true, false })
  {
    const Made made(ThreeSheets(shared));
    EXPECT_EQ(made.Facts().Patches, 3);
    EXPECT_EQ(made.Facts().JunctionEdges, 5);
    EXPECT_EQ(made.Facts().CommonVertices, 6);
    EXPECT_EQ(made.TheConnectivity.PatchOf, SheetIds());
    for (Index t = 0; t < made.TheMesh.TriangleCount(); ++t)
    {
      for (Index beyond : made.TheConnectivity.AcrossEdge[t])
      {
        EXPECT_TRUE(beyond == NoIndex ||
          made.TheConnectivity.PatchOf[beyond] == made.TheConnectivity.PatchOf[t]);
      }
    }
  }
}

TEST(Assembly, CommonVerticesAreTheLowest)
{
  const Mesh mesh = ThreeSheets(false);
  const Made made(mesh);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    Index lowest = 0;
    while (mesh.Points[lowest] != mesh.Points[v])
    {
      ++lowest;
    }
    EXPECT_EQ(made.TheAssembly.SameAs[v], lowest);
    EXPECT_EQ(
      made.TheConnectivity.Common[lowest], mesh.Points[v].x() == 4.0 && mesh.Points[v].z() == 0.0);
  }
}

TEST(Assembly, TheEndsOfAnEdgeStayApartHoweverShortItIs)
{
  const Mesh sliver{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0.5 * Tolerance, 0 }, { 0, 1, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
  const Made made(sliver);
  EXPECT_EQ(made.TheMesh.Triangles, sliver.Triangles);
  EXPECT_TRUE(made.TheAssembly.SameAs.empty()); // nothing was welded

  // What is at the very same positions is sewn there all the same.
  Mesh beside = sliver;
  Append(beside, { { { 2, 0, 0 }, { 1, 0.5 * Tolerance, 0 }, { 1, 0, 0 } }, { { 0, 1, 2 } } });
  EXPECT_EQ(Made(beside).TheAssembly.SameAs, (std::vector<Index>{ 0, 1, 2, 3, 4, 2, 1 }));
}

TEST(Assembly, SheetsBesideEachOtherAreSewnUnlessIdsPartThem)
{
  Mesh mesh = FlatGrid(4, 5);
  Mesh right = FlatGrid(4, 5);
  for (Vec3& point : right.Points)
  {
    point.x() += 4.0;
  }
  const Index half = mesh.TriangleCount();
  Append(mesh, right);
  const Made sewn(mesh);
  EXPECT_EQ(sewn.Facts().Patches, 1);
  EXPECT_EQ(sewn.Facts().CommonVertices, 0);
  EXPECT_EQ(sewn.Facts().OpenEdges, 2 * (8 + 5));

  std::vector<Index> ids(mesh.Triangles.size(), 0);
  std::fill(ids.begin() + half, ids.end(), 1);
  const Made parted(mesh, ids);
  EXPECT_EQ(parted.Facts().Patches, 2);
  EXPECT_EQ(parted.Facts().CommonVertices, 6);
  EXPECT_EQ(parted.Facts().JunctionEdges, 0);
}

TEST(Assembly, OneIdGoesOnThroughAJunction)
{
  // The two flat sheets bear one id: they are one patch, on which the upright one ends.
  std::vector<Index> ids = SheetIds();
  for (Index& id : ids)
  {
    id = id == 2 ? 1 : 0;
  }
  const Made made(ThreeSheets(false), ids);
  EXPECT_EQ(made.Facts().Patches, 2);
  EXPECT_EQ(made.Facts().CommonVertices, 6);
}

TEST(Assembly, TheFaceBetweenClosedPartsIsOnePatch)
{
  Mesh mesh = Box(2, 3, 2);
  Mesh other = Box(2, 3, 2);
  for (Vec3& point : other.Points)
  {
    point.x() = -point.x(); // touches at x = 0 with the same triangles, seen from behind
  }
  for (Triangle& triangle : other.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  std::vector<Index> ids(mesh.Triangles.size(), 4);
  Append(mesh, other);
  ids.resize(mesh.Triangles.size(), 7);
  const Made made(mesh, ids);
  EXPECT_EQ(made.Facts().Patches, 3);
  EXPECT_EQ(made.Facts().LeftOutTriangles, 2 * 3 * 2);
  EXPECT_EQ(made.Facts().JunctionEdges, 2 * (3 + 2));
  EXPECT_EQ(made.Facts().OpenEdges, 0);
  EXPECT_EQ(made.TheAssembly.Kept.size(), made.TheMesh.Triangles.size());
}

TEST(Assembly, TrianglesAreWoundOneWayRound)
{
  for (const Mesh& right : { Torus(3.0, 1.0, 24, 12), Tube(2.0, 12, 5, 4.0) })
  {
    Mesh mixed = right;
    Index turned = 0;
    for (std::size_t t = 0; t < mixed.Triangles.size(); ++t)
    {
      if (t % 3 == 1)
      {
        std::swap(mixed.Triangles[t][0], mixed.Triangles[t][2]);
        ++turned;
      }
    }
    const Made made(mixed);
    EXPECT_EQ(made.Facts().Orientation.FlippedTriangles, turned); // the smaller part
    EXPECT_TRUE(IsWoundOneWay(made));
    EXPECT_EQ(made.Facts().Orientation.OneSidedPatches, 0);
    EXPECT_TRUE(made.TheConnectivity.Common.empty());
  }
}

TEST(Assembly, PatchesThatMeetWithoutAThirdAreWoundAlike)
{
  Mesh mesh = FlatGrid(8, 5);
  std::vector<Index> ids;
  for (Triangle& triangle : mesh.Triangles)
  {
    const bool left = Corners(mesh, static_cast<Index>(ids.size())).Centroid().x() < 3.0;
    ids.push_back(left ? 0 : 1);
    if (left)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  const Made made(mesh, ids);
  for (Index t = 0; t < made.TheMesh.TriangleCount(); ++t)
  {
    EXPECT_GT(Corners(made.TheMesh, t).AreaVector().z(), 0.0);
  }
}

TEST(Assembly, AStripWithOneSideIsCutOnce)
{
  const Made made(Moebius(20));
  EXPECT_EQ(made.Facts().Patches, 1);
  EXPECT_EQ(made.Facts().Orientation.OneSidedPatches, 1);
  EXPECT_EQ(made.Facts().JunctionEdges, 0);
  EXPECT_TRUE(IsWoundOneWay(made));
  // The cut runs across the strip of two squares' width.
  EXPECT_GE(made.Facts().CommonVertices, 3);
  EXPECT_LE(made.Facts().CommonVertices, 9);
  EXPECT_EQ(MakeAssembly(*std::make_unique<Mesh>(Moebius(20)),
              *std::make_unique<Connectivity>(Moebius(20)), {}, Tolerance)
              .Facts.OpenEdges,
    40);
}

TEST(Assembly, APatchSeesItselfAndACommonVertexAll)
{
  const Made made(ThreeSheets(true));
  const Mesh& mesh = made.TheMesh;
  const Connectivity& connectivity = made.TheConnectivity;
  ConnectedWindow walk(mesh, connectivity);
  const WindowGrid grid(mesh, 1.2);
  SpatialWindow space(mesh, connectivity, grid);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (connectivity.TrianglesOfVertex[v].empty())
    {
      continue;
    }
    for (const std::vector<Index>& window : { walk.Gather(v, 1.2), space.Gather(v, 1.2) })
    {
      std::set<Index> patches;
      for (Index t : window)
      {
        patches.insert(connectivity.PatchOf[t]);
      }
      EXPECT_EQ(patches.size(), connectivity.Common[v] ? 3u : 1u) << "vertex " << v;
    }
  }
}

TEST(Assembly, ThinningKeepsWhatIsOnTheBoundaryOfAPatch)
{
  const Made made(ThreeSheets(true));
  Flags region(made.TheMesh.Points.size(), 0);
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    region[v] = !made.TheConnectivity.TrianglesOfVertex[static_cast<Index>(v)].empty() &&
      (made.TheMesh.Points[v] - Vec3(4.0, 2.5, 0.0)).norm() < 2.6;
  }
  const std::vector<int> rounds =
    ThinningRounds(made.TheMesh, made.TheConnectivity, region, {}, Monitor());
  const int last = *std::max_element(rounds.begin(), rounds.end());
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (region[v] && made.TheConnectivity.Common[v])
    {
      EXPECT_EQ(rounds[v], last);
    }
  }
  EXPECT_GT(last, 1); // and others are thinned
}

TEST(PatchesApart, ShareNoVertex)
{
  const Made made(ThreeSheets(true));
  const PatchesApart apart = TakeApart(made.TheMesh, made.TheConnectivity);
  EXPECT_EQ(apart.Parts.Points.size(), made.TheMesh.Points.size() + 2 * 6);
  std::vector<Index> patchOfVertex(apart.Parts.Points.size(), NoIndex);
  for (Index t = 0; t < apart.Parts.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index v = apart.Parts.Triangles[t][k];
      EXPECT_EQ(apart.WholeOf[v], made.TheMesh.Triangles[t][k]);
      EXPECT_EQ(apart.Parts.Points[v], made.TheMesh.Points[made.TheMesh.Triangles[t][k]]);
      EXPECT_TRUE(
        patchOfVertex[v] == NoIndex || patchOfVertex[v] == made.TheConnectivity.PatchOf[t]);
      patchOfVertex[v] = made.TheConnectivity.PatchOf[t];
    }
  }
}
