// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Settled.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 40;
constexpr Index Middle = MiddleOfGrid(Width);

/// What is settled of a flat grid whose local scale is the same everywhere.
Settled SettledOf(const Mesh& mesh, double scale, const std::vector<Index>& open)
{
  return FindSettled(
    mesh, Connectivity(mesh), std::vector<double>(mesh.Points.size(), scale), open);
}
}

TEST(Settled, IsAllThatIsFarFromEverythingOpen)
{
  const Mesh mesh = FlatGrid(Width, Width);
  for (const double scale : { 1.0, 2.0 })
  {
    const Settled settled = SettledOf(mesh, scale, { Middle });
    for (std::size_t v = 0; v < mesh.Points.size(); ++v)
    {
      const double distance = (mesh.Points[v] - mesh.Points[Middle]).norm() / scale;
      EXPECT_EQ(settled.Vertices[v] != 0, distance > 6.0) << "vertex " << v;
      EXPECT_EQ(settled.Unfitted[v] != 0, distance > 8.0) << "vertex " << v;
    }
  }
}

TEST(Settled, IsAllWhereNothingIsOpen)
{
  const Mesh mesh = FlatGrid(Width, Width);
  const Settled settled = SettledOf(mesh, 1.0, {});
  EXPECT_EQ(settled.Vertices, Flags(mesh.Points.size(), 1));
  EXPECT_EQ(settled.Unfitted, Flags(mesh.Points.size(), 1));
}

TEST(Settled, IsWhatIsNearInSpaceOnly)
{
  // Two grids, one just above the other, that no edge connects.
  Mesh mesh = FlatGrid(Width, Width);
  const Index count = mesh.VertexCount();
  const Mesh one = mesh;
  for (const Vec3& point : one.Points)
  {
    mesh.Points.emplace_back(point + Vec3(0.0, 0.0, 0.5));
  }
  for (const Triangle& t : one.Triangles)
  {
    mesh.Triangles.push_back({ t[0] + count, t[1] + count, t[2] + count });
  }
  const Settled settled = SettledOf(mesh, 1.0, { Middle });
  EXPECT_EQ(settled.Vertices[Middle], 0);
  EXPECT_EQ(settled.Vertices[Middle + count], 1);
}
