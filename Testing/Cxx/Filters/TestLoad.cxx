// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkSphereSource.h>

#include <fstream>
#include <random>
#include <unistd.h>

using namespace arris::testing;

// The largest, the least and the most: meshes at the ends of what there is.

namespace
{
/// A mesh of these points and triangles, with the arrays that the filters may need.
vtkSmartPointer<vtkPolyData> MeshOf(
  const std::vector<Point3>& positions, const std::vector<std::array<vtkIdType, 3>>& triangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    points->SetPoint(static_cast<vtkIdType>(v), positions[v].data());
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(triangles.size()), 3 * triangles.size());
  for (const auto& triangle : triangles)
  {
    cells->InsertNextCell(3, triangle.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  AddQuietArrays(mesh);
  return mesh;
}

/// Single triangles in rows of a thousand, with a little room between them.
vtkSmartPointer<vtkPolyData> Apart(int count)
{
  std::vector<Point3> points;
  std::vector<std::array<vtkIdType, 3>> triangles;
  for (int i = 0; i < count; ++i)
  {
    const double x = 1.1 * (i % 1000);
    const double y = 1.1 * (i / 1000);
    const vtkIdType first = 3 * static_cast<vtkIdType>(i);
    points.insert(points.end(), { { x, y, 0.0 }, { x + 1.0, y, 0.0 }, { x, y + 1.0, 0.0 } });
    triangles.push_back({ first, first + 1, first + 2 });
  }
  return MeshOf(points, triangles);
}

/// A flat cone: `count` triangles around one vertex.
vtkSmartPointer<vtkPolyData> Fan(int count)
{
  std::vector<Point3> points{ { 0.0, 0.0, 0.3 } };
  std::vector<std::array<vtkIdType, 3>> triangles;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    triangles.push_back({ 0, i + 1, (i + 1) % count + 1 });
  }
  return MeshOf(points, triangles);
}

/// A sheet with a peak or a pit at each of its points.
vtkSmartPointer<vtkPolyData> EggBox(int side)
{
  std::vector<Point3> points;
  std::vector<std::array<vtkIdType, 3>> triangles;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      points.emplace_back(x, y, (x + y) % 2 == 0 ? 1.0 : -1.0);
    }
  }
  for (int y = 0; y + 1 < side; ++y)
  {
    for (int x = 0; x + 1 < side; ++x)
    {
      const vtkIdType a = y * side + x;
      triangles.push_back({ a, a + 1, a + side + 1 });
      triangles.push_back({ a, a + side + 1, a + side });
    }
  }
  return MeshOf(points, triangles);
}

bool AllFinite(vtkPolyData* mesh)
{
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    Point3 p;
    mesh->GetPoint(v, p.data());
    if (!p.allFinite())
    {
      return false;
    }
  }
  return true;
}

/// Bytes of memory in use by this process.
double MemoryInUse()
{
  std::ifstream statm("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}
}

class Load : public EachFilter
{
protected:
  /// Runs the filter; the points stay where they are.
  void ExpectKept(vtkPolyData* input)
  {
    vtkNew<ErrorCounter> errors;
    errors->Watch(this->Filter);
    Execute(this->Filter, input);
    EXPECT_EQ(errors->Count, 0) << errors->Text;
    ASSERT_EQ(this->MeshOutput()->GetNumberOfPoints(), input->GetNumberOfPoints());
    EXPECT_TRUE(
      SameBytes(this->MeshOutput()->GetPoints()->GetData(), input->GetPoints()->GetData()));
  }
};

TEST_P(Load, OneTriangle)
{
  this->ExpectKept(Apart(1));
}

TEST_P(Load, AMillionTrianglesApart)
{
  const auto input = Apart(1000000);
  if (std::string(GetParam().Name) == "Extractor") // it wants a surface, not a soup
  {
    vtkNew<ErrorCounter> errors;
    errors->Watch(this->Filter);
    Execute(this->Filter, input);
    EXPECT_EQ(errors->Count, 1);
    EXPECT_NE(errors->Text.find("no two triangles share an edge"), std::string::npos);
    return;
  }
  this->ExpectKept(input);
}

// The windows of all vertices hold all triangles then: the time goes with the square of their
// number. A hundred thousand were tried by hand (Documentation/promises.md).
TEST_P(Load, AVertexOfManyTriangles)
{
  const auto input = Fan(5000);
  vtkNew<ErrorCounter> errors;
  errors->Watch(this->Filter);
  Execute(this->Filter, input);
  EXPECT_EQ(errors->Count, 0) << errors->Text;
  ASSERT_EQ(this->MeshOutput()->GetNumberOfPoints(), input->GetNumberOfPoints());
  EXPECT_TRUE(AllFinite(this->MeshOutput()));
}

INSTANTIATE_TEST_SUITE_P(Filters, Load, AllFilters(), FilterName);

TEST(LoadOfReconstruction, AMeshThatIsAllSharpRegion)
{
  const auto input = EggBox(16);
  for (const int method : { vtkSharpEdgeReconstruction::PAPER, vtkSharpEdgeReconstruction::ROBUST })
  {
    vtkNew<vtkSharpEdgeReconstruction> filter;
    filter->SetMethod(method);
    vtkNew<ErrorCounter> errors;
    errors->Watch(filter);
    const auto output = Execute(filter, input);
    EXPECT_EQ(errors->Count, 0) << errors->Text;
    ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
    EXPECT_TRUE(AllFinite(output));
    if (method == vtkSharpEdgeReconstruction::PAPER)
    {
      EXPECT_EQ(output->GetPointData()->GetArray("SharpRegion")->GetRange()[0], 1.0) << "all of it";
    }
  }
}

TEST(LoadOfReconstruction, AMeshWithoutSharpRegion)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  sphere->Update();
  vtkPolyData* input = sphere->GetOutput();
  for (const int method : { vtkSharpEdgeReconstruction::PAPER, vtkSharpEdgeReconstruction::ROBUST })
  {
    vtkNew<vtkSharpEdgeReconstruction> filter;
    filter->SetMethod(method);
    const auto output = Execute(filter, input);
    EXPECT_EQ(output->GetPointData()->GetArray("SharpRegion")->GetRange()[1], 0.0) << "none of it";
    EXPECT_TRUE(SameBytes(output->GetPoints()->GetData(), input->GetPoints()->GetData()));
  }
}

TEST(LoadOfReconstruction, TwoThousandMeshesLeaveNoMemoryBehind)
{
  constexpr int Meshes = 2000;
  constexpr int WarmUp = 500; // what is made once and kept is there by then
  std::mt19937 random(7);
  std::uniform_real_distribution<double> half(0.3, 0.7);
  vtkNew<vtkSharpEdgeReconstruction> reconstruction;
  vtkNew<vtkSharpEdgeExtractor> extractor;
  extractor->SetInputConnection(reconstruction->GetOutputPort());
  double before = 0.0;
  for (int i = 0; i < Meshes; ++i)
  {
    const double x = half(random);
    const double y = half(random);
    const Solid box = Prism({ { -x, -y }, { x, -y }, { x, y }, { -x, y } }, half(random));
    reconstruction->SetMethod(i % 2);
    reconstruction->SetInputData(Contour(box, 6 + i % 2));
    extractor->Update();
    ASSERT_GT(extractor->GetSurfaces()->GetNumberOfCells(), 0) << i;
    before = i == WarmUp ? MemoryInUse() : before;
  }
  // A thousand leaks of one small mesh would be some ten times this; the allocator's own moods are
  // below it.
  constexpr double Allowed = 2e6;
  EXPECT_LT(MemoryInUse() - before, Allowed);
}
