// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

using namespace arris::testing;

class EmptyInput : public EachFilter
{
protected:
  vtkNew<ErrorCounter> Errors;
  void SetUp() override { this->Errors->Watch(this->Filter); }
};

TEST_P(EmptyInput, GivesEmptyOutputWithoutAWord)
{
  vtkNew<vtkPolyData> nothing;
  Execute(this->Filter, nothing);
  EXPECT_EQ(this->Errors->Count, 0) << this->Errors->Text;
  for (int port = 0; port < this->Filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_EQ(this->Filter->GetOutput(port)->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->Filter->GetOutput(port)->GetNumberOfCells(), 0);
  }
}

TEST_P(EmptyInput, PointsWithoutCellsPass)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  points->InsertNextPoint(4.0, 5.0, 6.0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  AddQuietArrays(cloud);
  Execute(this->Filter, cloud);
  EXPECT_EQ(this->Errors->Count, 0) << this->Errors->Text;
  ASSERT_EQ(this->MeshOutput()->GetNumberOfPoints(), 2);
  EXPECT_TRUE(SameBytes(this->MeshOutput()->GetPoints()->GetData(), points->GetData()));
}

TEST_P(EmptyInput, LinesAlonePass)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  vtkNew<vtkCellArray> lines;
  const vtkIdType line[] = { 0, 1 };
  lines->InsertNextCell(2, line);
  vtkNew<vtkPolyData> wire;
  wire->SetPoints(points);
  wire->SetLines(lines);
  AddQuietArrays(wire);
  Execute(this->Filter, wire);
  EXPECT_EQ(this->Errors->Count, 0) << this->Errors->Text;
  ExpectSameCells(this->MeshOutput()->GetLines(), lines, "lines");
}

INSTANTIATE_TEST_SUITE_P(Filters, EmptyInput, FiltersOfMeshes(), FilterName);

class EmptyTriangles : public EmptyInput
{
};

TEST_P(EmptyTriangles, DoNotCrash)
{
  vtkNew<vtkPoints> points; // all in one place
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(1.0, 1.0, 1.0);
  }
  vtkNew<vtkCellArray> triangles;
  const vtkIdType a[] = { 0, 1, 2 };
  const vtkIdType b[] = { 1, 3, 2 };
  triangles->InsertNextCell(3, a);
  triangles->InsertNextCell(3, b);
  vtkNew<vtkPolyData> dot;
  dot->SetPoints(points);
  dot->SetPolys(triangles);
  AddArray<vtkUnsignedCharArray>(
    dot->GetPointData(), 4, "SharpRegion", [](vtkIdType) { return 1; });
  AddArray<vtkIntArray>(dot->GetPointData(), 4, "ThinningRound", [](vtkIdType) { return 1; });
  Execute(this->Filter, dot);
  EXPECT_EQ(this->Errors->Count, 0) << this->Errors->Text;
  ASSERT_EQ(this->MeshOutput()->GetNumberOfPoints(), 4);
  for (vtkIdType v = 0; v < 4; ++v)
  {
    Point3 p;
    this->MeshOutput()->GetPoint(v, p.data());
    EXPECT_EQ(p, Point3(1.0, 1.0, 1.0));
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, EmptyTriangles, AllFilters(), FilterName);

TEST(EmptyPieces, OfAMeshInSeveralAreNoError)
{
  vtkNew<vtkSharpEdgeExtractor> filter;
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(errors->Count, 0) << errors->Text;
  ExpectEmptyOutputs(filter);
}
