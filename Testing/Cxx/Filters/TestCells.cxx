// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <set>

using namespace arris::testing;

namespace
{
/// One of each kind of cell: vertices, polylines, a triangle, a quad, a concave polygon and a
/// strip; with the number of each cell as cell data.
vtkSmartPointer<vtkPolyData> MixedCells()
{
  vtkNew<vtkPoints> points;
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 6; ++i)
    {
      points->InsertNextPoint(i, j, 0.25 * i * i);
    }
  }
  points->InsertNextPoint(3.5, 1.4, 2.0); // the dent of the concave polygon
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  const auto cells = [](std::initializer_list<std::vector<vtkIdType>> lists)
  {
    auto array = vtkSmartPointer<vtkCellArray>::New();
    for (const std::vector<vtkIdType>& ids : lists)
    {
      array->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    return array;
  };
  mesh->SetVerts(cells({ { 0 }, { 5, 6 } }));
  mesh->SetLines(cells({ { 0, 1, 2, 3 }, { 4, 5 } }));
  mesh->SetPolys(cells({ { 0, 1, 7 }, { 1, 2, 8, 7 }, { 2, 3, 4, 10, 24, 8 } }));
  mesh->SetStrips(cells({ { 12, 18, 13, 19, 14, 20 } }));
  AddArray<vtkIntArray>(mesh->GetCellData(), mesh->GetNumberOfCells(), "CellNumber",
    [](vtkIdType i) { return static_cast<int>(i); });
  AddArray<vtkDoubleArray>(
    mesh->GetPointData(), mesh->GetNumberOfPoints(), "PointNumber", [](vtkIdType i) { return i; });
  AddArray<vtkDoubleArray>(mesh->GetFieldData(), 3, "Remark", [](vtkIdType i) { return i; });
  AddQuietArrays(mesh);
  return mesh;
}

std::set<vtkIdType> PointsOfCell(vtkPolyData* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  return { ids->begin(), ids->end() };
}
}

class Cells : public EachFilter
{
};

TEST_P(Cells, AreCutIntoTrianglesThatKnowWhatTheyWereCutFrom)
{
  const auto input = MixedCells();
  Execute(this->Filter, input);
  vtkPolyData* output = this->MeshOutput();
  EXPECT_EQ(output->GetNumberOfStrips(), 0);
  EXPECT_EQ(output->GetNumberOfPolys(), 1 + 2 + 4 + 4);
  ASSERT_EQ(output->GetNumberOfCells(), 4 + 11);
  vtkDataArray* numbers = output->GetCellData()->GetArray("CellNumber");
  ASSERT_NE(numbers, nullptr);
  ASSERT_EQ(numbers->GetNumberOfTuples(), output->GetNumberOfCells());
  std::multiset<int> origins;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const int from = static_cast<int>(numbers->GetComponent(cell, 0));
    origins.insert(from);
    const std::set<vtkIdType> now = PointsOfCell(output, cell);
    const std::set<vtkIdType> before = PointsOfCell(input, from);
    EXPECT_TRUE(std::includes(before.begin(), before.end(), now.begin(), now.end()))
      << "cell " << cell << " is no part of " << from;
  }
  EXPECT_EQ(origins, (std::multiset<int>{ 0, 1, 2, 3, 4, 5, 5, 6, 6, 6, 6, 7, 7, 7, 7 }));
}

TEST_P(Cells, VerticesAndLinesPassUncut)
{
  const auto input = MixedCells();
  Execute(this->Filter, input);
  ExpectSameCells(this->MeshOutput()->GetVerts(), input->GetVerts(), "vertices");
  ExpectSameCells(this->MeshOutput()->GetLines(), input->GetLines(), "lines");
}

TEST_P(Cells, PointAndFieldDataPass)
{
  const auto input = MixedCells();
  Execute(this->Filter, input);
  vtkPolyData* output = this->MeshOutput();
  ASSERT_NE(output->GetPointData()->GetArray("PointNumber"), nullptr);
  EXPECT_TRUE(SameBytes(output->GetPointData()->GetArray("PointNumber"),
    input->GetPointData()->GetArray("PointNumber")));
  ASSERT_NE(output->GetFieldData()->GetArray("Remark"), nullptr);
  EXPECT_TRUE(SameBytes(
    output->GetFieldData()->GetArray("Remark"), input->GetFieldData()->GetArray("Remark")));
}

TEST_P(Cells, OfTrianglesKeepTheirData)
{
  const auto input = ReadyMesh();
  AddArray<vtkIntArray>(input->GetCellData(), input->GetNumberOfCells(), "CellNumber",
    [](vtkIdType i) { return static_cast<int>(i); });
  AddArray<vtkDoubleArray>(input->GetFieldData(), 3, "Remark", [](vtkIdType i) { return i; });
  Execute(this->Filter, input);
  vtkPolyData* output = this->MeshOutput();
  ExpectSameCells(output->GetPolys(), input->GetPolys(), "triangles");
  ASSERT_NE(output->GetCellData()->GetArray("CellNumber"), nullptr);
  EXPECT_TRUE(SameBytes(
    output->GetCellData()->GetArray("CellNumber"), input->GetCellData()->GetArray("CellNumber")));
  EXPECT_NE(output->GetFieldData()->GetArray("Remark"), nullptr);
}

TEST_P(Cells, ThatNameAPointTwiceChangeNothing)
{
  const auto clean = ReadyMesh();
  const auto dirty = Copy(clean);
  const vtkIdType degenerate[] = { 10, 10, 11 };
  dirty->GetPolys()->InsertNextCell(3, degenerate);
  const auto expected = Execute(GetParam().New(), clean);
  const auto actual = Execute(this->Filter, dirty);
  ASSERT_EQ(actual->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_TRUE(SameBytes(actual->GetPoints()->GetData(), expected->GetPoints()->GetData()));
  ExpectSameArrays(actual->GetPointData(), expected->GetPointData(), "point array");
  EXPECT_EQ(this->MeshOutput()->GetNumberOfPolys(), dirty->GetNumberOfPolys()) << "it passes";
}

INSTANTIATE_TEST_SUITE_P(Filters, Cells, AllFilters(), FilterName);

TEST(CellsOfSurfaces, AllThatIsNoTriangleHasNoSurface)
{
  const auto input = MixedCells();
  const vtkIdType degenerate[] = { 0, 0, 1 };
  input->GetPolys()->InsertNextCell(3, degenerate);
  input->SetStrips(nullptr);
  input->GetCellData()->Initialize();
  vtkNew<vtkSharpEdgeExtractor> filter;
  Execute(filter, input);
  vtkPolyData* surfaces = filter->GetSurfaces();
  vtkDataArray* ids = surfaces->GetCellData()->GetArray("SurfaceId");
  ASSERT_EQ(ids->GetNumberOfTuples(), surfaces->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < surfaces->GetNumberOfCells(); ++cell)
  {
    const bool triangle = PointsOfCell(surfaces, cell).size() == 3;
    EXPECT_EQ(ids->GetComponent(cell, 0) >= 0.0, triangle) << "cell " << cell;
  }
}
