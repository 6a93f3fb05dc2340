// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Assemblies.h"
#include "FilterTesting.h"

#include "Core/Intersections.h"

#include <map>
#include <numeric>

using namespace arris::testing;

// What hangs together how, by positions: an output has the cells of its input, but vertices may
// come to lie on each other, and common ones apart.

namespace
{
/// A ball through the top of a slab, of three materials: its junctions are circles.
vtkSmartPointer<vtkPolyData> BallInSlab(int cells)
{
  const Point center(0.3, -0.2, 2.9);
  const auto ball = [center](const Point& p) { return 4.1 - (p - center).norm(); };
  const auto slab = [](const Point& p) {
    return std::min({ 7.1 - std::abs(p.x()), 6.2 - std::abs(p.y()), 2.6 - std::abs(p.z()) });
  };
  const auto rest = [=](const Point& p) { return std::min(slab(p), -ball(p)); };
  const auto outside = [=](const Point& p) { return -std::max(slab(p), ball(p)); };
  return SurfaceNet({ outside, rest, ball }, cells).Make();
}

/// The triangles of a mesh on the different positions that its points have.
arris::Mesh ByPosition(vtkPolyData* data)
{
  arris::Mesh mesh;
  std::map<std::array<double, 3>, arris::Index> numbers;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < data->GetNumberOfPolys(); ++c)
  {
    data->GetPolys()->GetCellAtId(c, ids);
    arris::Triangle triangle;
    for (int k = 0; k < 3; ++k)
    {
      std::array<double, 3> p;
      data->GetPoint(ids->GetId(k), p.data());
      const auto [found, isNew] = numbers.emplace(p, mesh.VertexCount());
      if (isNew)
      {
        mesh.Points.emplace_back(p[0], p[1], p[2]);
      }
      triangle[k] = found->second;
    }
    mesh.Triangles.push_back(triangle);
  }
  return mesh;
}

/// How many parts hang together by these edges.
int Components(std::size_t vertices, const std::vector<std::pair<int, int>>& edges)
{
  std::vector<int> root(vertices);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v)
  {
    while (root[v] != v)
    {
      v = root[v] = root[root[v]];
    }
    return v;
  };
  int components = static_cast<int>(vertices);
  for (const auto& [a, b] : edges)
  {
    components -= find(a) != find(b) ? 1 : 0;
    root[find(a)] = find(b);
  }
  return components;
}

/// Euler number, components, loops of open edges, and how many edges have one triangle, two, ...
struct Topology
{
  int Euler;
  int Parts;
  int Loops;
  std::map<int, int> EdgesByTriangles;

  explicit Topology(const arris::Mesh& mesh)
  {
    std::map<std::pair<int, int>, int> trianglesOn;
    for (const arris::Triangle& t : mesh.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        ++trianglesOn[std::minmax({ t[k], t[arris::Next(k)] })];
      }
    }
    std::vector<std::pair<int, int>> all, open;
    std::set<int> openVertices;
    for (const auto& [edge, count] : trianglesOn)
    {
      ++this->EdgesByTriangles[count];
      all.push_back(edge);
      if (count == 1)
      {
        open.push_back(edge);
        openVertices.insert({ edge.first, edge.second });
      }
    }
    const auto size = [](const auto& these) { return static_cast<int>(these.size()); };
    this->Euler = size(mesh.Points) - size(all) + size(mesh.Triangles);
    this->Parts = Components(mesh.Points.size(), all);
    // Each vertex that is on no loop counts as one here.
    this->Loops = Components(mesh.Points.size(), open) - size(mesh.Points) + size(openVertices);
  }
  bool operator==(const Topology& other) const
  {
    return this->Euler == other.Euler && this->Parts == other.Parts && this->Loops == other.Loops &&
      this->EdgesByTriangles == other.EdgesByTriangles;
  }
};

/// Half of a mesh: what is left has open edges that end on its junctions.
vtkSmartPointer<vtkPolyData> Half(vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> ids;
  ids->SetName("PatchId");
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < mesh->GetNumberOfPolys(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, corners);
    if (mesh->GetPoint(corners->GetId(0))[0] < 0.5)
    {
      cells->InsertNextCell(corners);
      ids->InsertNextValue(
        static_cast<int>(mesh->GetCellData()->GetArray("PatchId")->GetTuple1(c)));
    }
  }
  auto half = vtkSmartPointer<vtkPolyData>::New();
  half->SetPoints(mesh->GetPoints());
  half->SetPolys(cells);
  half->GetCellData()->AddArray(ids);
  return half;
}

class AssemblyTopology : public ::testing::TestWithParam<bool>
{
protected:
  void SetUp() override
  {
    this->Before = BallInSlab(CleanCells);
    if (GetParam())
    {
      this->Before = Half(this->Before);
    }
    vtkNew<vtkSharpEdgeReconstruction> filter;
    this->After = Execute(filter, this->Before);
  }

  vtkSmartPointer<vtkPolyData> Before;
  vtkSmartPointer<vtkPolyData> After;
};
}

TEST_P(AssemblyTopology, Stays)
{
  const Topology before(ByPosition(this->Before));
  EXPECT_GT(before.EdgesByTriangles.at(3), 20) << "or there is no junction";
  EXPECT_EQ(before.Loops > 0, GetParam());
  EXPECT_TRUE(Topology(ByPosition(this->After)) == before);
}

TEST_P(AssemblyTopology, NothingCutsAnother)
{
  const arris::Mesh mesh = ByPosition(this->After);
  std::vector<arris::Index> all(mesh.Triangles.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(arris::FindIntersections(mesh, all).size(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Meshes, AssemblyTopology, ::testing::Bool(),
  [](const auto& test) { return std::string(test.param ? "Open" : "Closed"); });
