// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

using namespace arris::testing;

// What the preview shows is what the paper's first two filters compute.

namespace
{
vtkIdType CountRole(vtkDataArray* roles, int role)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < roles->GetNumberOfTuples(); ++i)
  {
    count += roles->GetComponent(i, 0) == role ? 1 : 0;
  }
  return count;
}

class Preview : public ::testing::Test
{
protected:
  Preview()
  {
    this->Filter->SetInputData(this->Input);
    this->Filter->Update();
    this->Classify->SetInputData(this->Input);
    this->Thin->SetInputConnection(this->Classify->GetOutputPort());
    this->Thin->Update();
  }
  vtkSmartPointer<vtkPolyData> Input = Contour(BracketSolid(), 24);
  vtkNew<vtkSharpEdgePreview> Filter;
  vtkNew<vtkUSSODFilter> Classify;
  vtkNew<vtkSharpThinningFilter> Thin;
};
}

TEST_F(Preview, IsTheClassifiedAndThinnedMesh)
{
  ExpectIdentical(this->Filter->GetOutput(), this->Thin->GetOutput());
  EXPECT_STREQ(
    this->Filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "NormalDeviation");
}

TEST_F(Preview, OutlinesTheRegion)
{
  // A triangle with corners inside and outside has one segment of the outline, no other has any.
  vtkPolyData* mesh = this->Filter->GetOutput();
  vtkDataArray* region = mesh->GetPointData()->GetArray("SharpRegion");
  vtkIdType mixed = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    double inside = 0.0;
    for (const vtkIdType v : *ids)
    {
      inside += region->GetComponent(v, 0);
    }
    mixed += inside == 1.0 || inside == 2.0 ? 1 : 0;
  }
  vtkPolyData* marks = this->Filter->GetMarks();
  EXPECT_GT(mixed, 0);
  EXPECT_EQ(marks->GetNumberOfLines(), mixed);
  EXPECT_EQ(CountRole(marks->GetCellData()->GetArray("SkeletonRole"), 0), mixed);
}

TEST_F(Preview, MarksEachVertexOfTheSkeletonByItsRole)
{
  vtkDataArray* roles = this->Filter->GetOutput()->GetPointData()->GetArray("SkeletonRole");
  vtkPolyData* marks = this->Filter->GetMarks();
  vtkDataArray* marked = marks->GetCellData()->GetArray("SkeletonRole");
  ASSERT_EQ(marked->GetNumberOfTuples(), marks->GetNumberOfCells());
  // All balls have as many triangles; tubes are strips.
  const vtkIdType vertices = CountRole(roles, 1) + CountRole(roles, 2) + CountRole(roles, 3);
  ASSERT_GT(CountRole(roles, 2), 0);
  ASSERT_EQ(marks->GetNumberOfPolys() % vertices, 0);
  const vtkIdType triangles = marks->GetNumberOfPolys() / vertices;
  EXPECT_GT(triangles, 8);
  EXPECT_EQ(CountRole(marked, 2), triangles * CountRole(roles, 2));
  EXPECT_EQ(CountRole(marked, 3), triangles * CountRole(roles, 3));
  EXPECT_EQ(CountRole(marked, 1), triangles * CountRole(roles, 1) + marks->GetNumberOfStrips());
  EXPECT_GT(marks->GetNumberOfStrips(), 0);
}

TEST_F(Preview, TakesTheTubesRadiusInEdgeLengths)
{
  const double edge = this->Filter->GetUsedWindow() / this->Filter->GetUsedWindowRatio();
  double bounds[6];
  double mesh[6];
  this->Filter->GetOutput()->GetBounds(mesh);
  for (const double radius : { 0.15, 1.0 })
  {
    this->Filter->SetTubeRadius(radius);
    this->Filter->Update();
    this->Filter->GetMarks()->GetBounds(bounds);
    // Marks stick out by no more than the radius of the largest ball.
    EXPECT_GT(mesh[0] - bounds[0], 0.0);
    EXPECT_LE(mesh[0] - bounds[0], 2.5 * radius * edge + 1e-6);
    EXPECT_GT(mesh[0] - bounds[0], 0.5 * radius * edge);
  }
  vtkNew<ErrorCounter> errors;
  errors->Watch(this->Filter);
  this->Filter->SetTubeRadius(0.0);
  this->Filter->Update();
  EXPECT_EQ(errors->Count, 1);
  ExpectEmptyOutputs(this->Filter);
}
