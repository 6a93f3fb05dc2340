// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

using namespace arris::testing;

namespace
{
double Field(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return data->GetCellData()->GetArray(name)->GetComponent(cell, 0);
}
}

class Extractor : public ::testing::Test
{
protected:
  /// The unit cube in twelve triangles.
  vtkSmartPointer<vtkPolyData> Cube = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkSharpEdgeExtractor> Filter;

  void SetUp() override
  {
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 8; ++i)
    {
      points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
    }
    vtkNew<vtkCellArray> quads;
    const vtkIdType faces[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
      { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
    for (const auto& face : faces)
    {
      quads->InsertNextCell(4, face);
    }
    this->Cube->SetPoints(points);
    this->Cube->SetPolys(quads);
    AddArray<vtkIntArray>(
      this->Cube->GetPointData(), 8, "Number", [](vtkIdType i) { return static_cast<int>(i); });
  }
};

TEST_F(Extractor, FindsTheEdgesCornersAndFacesOfACube)
{
  const auto curves = Execute(this->Filter, this->Cube);
  ASSERT_EQ(curves->GetNumberOfLines(), 12);
  ASSERT_EQ(curves->GetNumberOfCells(), 12);
  for (vtkIdType cell = 0; cell < 12; ++cell)
  {
    EXPECT_EQ(Field(curves, "CurveId", cell), static_cast<double>(cell));
    EXPECT_DOUBLE_EQ(Field(curves, "Length", cell), 1.0);
    EXPECT_NEAR(Field(curves, "DihedralAngle", cell), 90.0, 1e-4); // kept in single precision
  }
  vtkPolyData* corners = this->Filter->GetCorners();
  ASSERT_EQ(corners->GetNumberOfVerts(), 8);
  EXPECT_EQ(corners->GetPointData()->GetArray("Valence")->GetRange()[0], 3.0);
  EXPECT_EQ(corners->GetPointData()->GetArray("Valence")->GetRange()[1], 3.0);
  vtkPolyData* surfaces = this->Filter->GetSurfaces();
  ASSERT_EQ(surfaces->GetNumberOfPolys(), 12);
  std::vector<int> triangles(6, 0);
  for (vtkIdType cell = 0; cell < 12; ++cell)
  {
    ++triangles.at(static_cast<std::size_t>(Field(surfaces, "SurfaceId", cell)));
  }
  EXPECT_EQ(triangles, std::vector<int>(6, 2));
}

TEST_F(Extractor, CarriesThePointArraysAlong)
{
  const auto curves = Execute(this->Filter, this->Cube);
  for (vtkPolyData* part : { curves.Get(), this->Filter->GetCorners() })
  {
    vtkDataArray* numbers = part->GetPointData()->GetArray("Number");
    ASSERT_NE(numbers, nullptr);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      Point3 here, there;
      part->GetPoint(i, here.data());
      this->Cube->GetPoint(static_cast<vtkIdType>(numbers->GetComponent(i, 0)), there.data());
      EXPECT_EQ(here, there);
    }
  }
}

TEST_F(Extractor, WithoutTurnsStillEndsAtTrueCorners)
{
  this->Filter->SetCornerAngle(180.0);
  EXPECT_EQ(Execute(this->Filter, this->Cube)->GetNumberOfLines(), 12);
}

TEST_F(Extractor, FindsNothingAboveTheAngle)
{
  this->Filter->SetFeatureAngle(91.0);
  EXPECT_EQ(Execute(this->Filter, this->Cube)->GetNumberOfCells(), 0);
  EXPECT_EQ(this->Filter->GetCorners()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetSurfaces()->GetCellData()->GetArray("SurfaceId")->GetRange()[1], 0.0);
}

TEST_F(Extractor, SplitsWhereACurveTurnsUnlessToldNotTo)
{
  // A lid, folded down, has one closed feature of four straight sides, but for its open rim.
  this->Filter->BoundaryEdgesOff();
  this->Cube->GetPolys()->Reset();
  const vtkIdType base[] = { 0, 2, 3, 1 };
  this->Cube->GetPolys()->InsertNextCell(4, base);
  vtkNew<vtkPoints> points;
  points->DeepCopy(this->Cube->GetPoints());
  for (int i = 4; i < 8; ++i) // spread the upper corners: four sloping flaps that do not touch
  {
    points->SetPoint(i, 3.0 * (i & 1) - 1.0, 3.0 * (i >> 1 & 1) - 1.0, 1.0);
  }
  this->Cube->SetPoints(points);
  const vtkIdType flaps[4][3] = { { 0, 1, 4 }, { 1, 3, 5 }, { 3, 2, 7 }, { 2, 0, 6 } };
  for (const auto& flap : flaps)
  {
    this->Cube->GetPolys()->InsertNextCell(3, flap);
  }
  const auto split = Execute(this->Filter, this->Cube);
  EXPECT_EQ(split->GetNumberOfLines(), 4);
  EXPECT_EQ(this->Filter->GetCorners()->GetNumberOfPoints(), 4);
  this->Filter->SetCornerAngle(180.0);
  const auto whole = Execute(this->Filter, this->Cube);
  ASSERT_EQ(whole->GetNumberOfLines(), 1);
  EXPECT_DOUBLE_EQ(Field(whole, "Length", 0), 4.0);
  EXPECT_EQ(whole->GetLines()->GetCellSize(0), 5) << "a closed curve names its first point twice";
  EXPECT_EQ(whole->GetNumberOfPoints(), 4);
  EXPECT_EQ(this->Filter->GetCorners()->GetNumberOfPoints(), 0);
}

TEST_F(Extractor, DihedralAngleIsTheMeanByLength)
{
  // A straight fold of two parts: 3 units long at 90 degrees, 1 unit at 45.
  vtkNew<vtkPoints> points;
  const double fold[3] = { 0.0, 3.0, 4.0 };
  for (const double y : fold)
  {
    points->InsertNextPoint(0.0, y, 0.0);
  }
  points->InsertNextPoint(-1.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, -1.0);
  points->InsertNextPoint(-1.0, 3.5, 0.0);
  points->InsertNextPoint(1.0, 3.5, -1.0);
  const vtkIdType triangles[4][3] = { { 0, 1, 3 }, { 1, 0, 4 }, { 1, 2, 5 }, { 2, 1, 6 } };
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : triangles)
  {
    cells->InsertNextCell(3, triangle);
  }
  mesh->SetPolys(cells);
  this->Filter->BoundaryEdgesOff();
  const auto curves = Execute(this->Filter, mesh);
  ASSERT_EQ(curves->GetNumberOfLines(), 1);
  EXPECT_DOUBLE_EQ(Field(curves, "Length", 0), 4.0);
  EXPECT_NEAR(Field(curves, "DihedralAngle", 0), (3.0 * 90.0 + 1.0 * 45.0) / 4.0, 1e-4);
  EXPECT_NEAR(Field(curves, "MinimumDihedralAngle", 0), 45.0, 1e-4);
  EXPECT_NEAR(Field(curves, "MaximumDihedralAngle", 0), 90.0, 1e-4);
  const double along[] = { 90.0, 67.5, 45.0 };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(
      curves->GetPointData()->GetArray("DihedralAngle")->GetComponent(i, 0), along[i], 1e-4);
  }
}
