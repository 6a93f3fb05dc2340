// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkTable.h>

using namespace arris::testing;

// Names, types and ranges of what the filters add: part of their interface.

namespace
{
void ExpectArray(vtkFieldData* attributes, const char* name, int type, int components, double least,
  double greatest)
{
  vtkDataArray* array = attributes->GetArray(name);
  ASSERT_NE(array, nullptr) << name;
  EXPECT_EQ(array->GetDataType(), type) << name;
  EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
  for (int c = 0; c < components; ++c)
  {
    EXPECT_GE(array->GetRange(c)[0], least) << name;
    EXPECT_LE(array->GetRange(c)[1], greatest) << name;
  }
}

void ExpectClassification(vtkPolyData* output)
{
  vtkPointData* points = output->GetPointData();
  const double lambda = output->GetFieldData()->GetArray("Lambda")->GetComponent(0, 0);
  ExpectArray(points, "USSOD", VTK_DOUBLE, 1, 0.0, 2.0 / lambda);
  ExpectArray(points, "NormalDeviation", VTK_DOUBLE, 1, 0.0, 180.0);
  ExpectArray(points, "SharpRegion", VTK_UNSIGNED_CHAR, 1, 0.0, 1.0);
  // The three say the same: SharpRegion is where 1 - λτ is the cosine of an angle that is sharp.
  for (vtkIdType v = 0; v < output->GetNumberOfPoints(); ++v)
  {
    const double cosine = 1.0 - lambda * points->GetArray("USSOD")->GetComponent(v, 0);
    const double angle = points->GetArray("NormalDeviation")->GetComponent(v, 0);
    ASSERT_NEAR(std::cos(angle * 3.14159265358979323846 / 180.0), cosine, 1e-12);
    const bool sharp = points->GetArray("SharpRegion")->GetComponent(v, 0) != 0.0;
    ASSERT_EQ(sharp, angle >= 41.4096221092709) << angle;
  }
  for (const char* name : { "Lambda", "SharpAngle", "AverageEdgeLength", "ClassificationSeconds" })
  {
    ExpectArray(output->GetFieldData(), name, VTK_DOUBLE, 1, 0.0, 1e3);
  }
}

void ExpectThinning(vtkPolyData* output)
{
  vtkPointData* points = output->GetPointData();
  ExpectArray(points, "ThinningRound", VTK_INT, 1, -1.0, 1000.0);
  ExpectArray(points, "SkeletonRole", VTK_UNSIGNED_CHAR, 1, 0.0, 3.0);
  vtkDataArray* rounds = points->GetArray("ThinningRound");
  const double last = rounds->GetRange()[1];
  EXPECT_GT(last, 1.0);
  for (vtkIdType v = 0; v < output->GetNumberOfPoints(); ++v)
  {
    const double round = rounds->GetComponent(v, 0);
    ASSERT_NE(round, 0.0);
    ASSERT_EQ(points->GetArray("SharpRegion")->GetComponent(v, 0) == 0.0, round == -1.0);
    ASSERT_EQ(points->GetArray("SkeletonRole")->GetComponent(v, 0) != 0.0, round == last);
  }
  ExpectArray(output->GetFieldData(), "ThinningSeconds", VTK_DOUBLE, 1, 0.0, 1e3);
}

void ExpectDisplacement(vtkPolyData* output, vtkPolyData* input)
{
  ExpectArray(output->GetPointData(), "Displacement", VTK_DOUBLE, 3, -1.0, 1.0);
  double longest = 0.0;
  for (vtkIdType v = 0; v < output->GetNumberOfPoints(); ++v)
  {
    Point3 now, before, step;
    output->GetPoint(v, now.data());
    input->GetPoint(v, before.data());
    output->GetPointData()->GetArray("Displacement")->GetTuple(v, step.data());
    ASSERT_EQ(step, Point3(now - before));
    longest = std::max(longest, step.norm());
  }
  EXPECT_GT(longest, 0.0) << "nothing moved";
  ExpectArray(output->GetFieldData(), "SharpeningSeconds", VTK_DOUBLE, 1, 0.0, 1e3);
}
}

TEST(Arrays, OfUSSOD)
{
  const auto mesh = Contour(BracketSolid(), 24);
  vtkNew<vtkUSSODFilter> filter;
  ExpectClassification(Execute(filter, mesh));
}

TEST(Arrays, FieldDataTellTheParametersUsed)
{
  const auto mesh = Contour(BracketSolid(), 24);
  vtkNew<vtkUSSODFilter> filter;
  filter->SetWindowRatio(1.25);
  filter->SetSharpAngle(60.0);
  const auto field = [&](const char* name)
  { return filter->GetOutput()->GetFieldData()->GetArray(name)->GetComponent(0, 0); };
  Execute(filter, mesh);
  EXPECT_EQ(field("SharpAngle"), 60.0);
  EXPECT_DOUBLE_EQ(field("Lambda"), 1.25 * field("AverageEdgeLength"));
  // A contour's edges are a bit shorter than its cells.
  EXPECT_NEAR(field("AverageEdgeLength"), 0.7 * CellWidth(24), 0.3 * CellWidth(24));
  EXPECT_DOUBLE_EQ(filter->GetKappa(), 0.5 / field("Lambda")) << "1 - cos 60 degrees";

  filter->SetWindow(0.125);
  Execute(filter, mesh);
  EXPECT_EQ(field("Lambda"), 0.125) << "a length goes before the ratio";
}

TEST(Arrays, OfThinning)
{
  const auto mesh = ReadyMesh();
  vtkNew<vtkSharpThinningFilter> filter;
  ExpectThinning(Execute(filter, mesh));
}

TEST(Arrays, OfSharpening)
{
  const auto mesh = ReadyMesh();
  vtkNew<vtkSharpeningFilter> filter;
  ExpectDisplacement(Execute(filter, mesh), mesh);
}

TEST(Arrays, OfReconstruction)
{
  const auto mesh = Contour(BracketSolid(), 24);
  const auto output = RecoverByPaper(mesh);
  ExpectClassification(output);
  ExpectThinning(output);
  ExpectDisplacement(output, mesh);
}

TEST(Arrays, OfTheDefaultMethod)
{
  const auto mesh = Contour(BracketSolid(), 24);
  vtkNew<vtkSharpEdgeReconstruction> filter;
  EXPECT_EQ(filter->GetMethod(), vtkSharpEdgeReconstruction::ROBUST);
  const auto output = Execute(filter, mesh);
  for (const char* name :
    { "USSOD", "NormalDeviation", "SharpRegion", "ThinningRound", "SkeletonRole", "Displacement" })
  {
    EXPECT_NE(output->GetPointData()->GetArray(name), nullptr) << name;
  }
}

TEST(Arrays, OfTheExtractor)
{
  vtkNew<vtkSharpEdgeExtractor> filter;
  const auto curves = Execute(filter, RecoverByPaper(Contour(BoxSolid(), 24)));
  const auto count = static_cast<double>(curves->GetNumberOfCells());
  const auto points = static_cast<double>(filter->GetSurfaces()->GetNumberOfPoints());
  const auto faces = static_cast<double>(filter->GetFaces()->GetNumberOfRows());
  vtkCellData* cells = curves->GetCellData();
  ExpectArray(cells, "CurveId", VTK_INT, 1, 0.0, count - 1.0);
  for (const char* name : { "DihedralAngle", "MinimumDihedralAngle", "MaximumDihedralAngle" })
  {
    ExpectArray(cells, name, VTK_DOUBLE, 1, 0.0, 180.0);
  }
  ExpectArray(cells, "Length", VTK_DOUBLE, 1, 0.0, 20.0);
  ExpectArray(cells, "CurveKind", VTK_UNSIGNED_CHAR, 1, 0.0, 3.0);
  ExpectArray(cells, "Closed", VTK_UNSIGNED_CHAR, 1, 0.0, 1.0);
  ExpectArray(cells, "LeftSurfaceId", VTK_INT, 1, 0.0, faces - 1.0);
  ExpectArray(cells, "RightSurfaceId", VTK_INT, 1, 0.0, faces - 1.0);
  ExpectArray(curves->GetPointData(), "DihedralAngle", VTK_DOUBLE, 1, 0.0, 180.0);
  ExpectArray(curves->GetPointData(), "Tangent", VTK_DOUBLE, 3, -1.0, 1.0);
  ExpectArray(curves->GetPointData(), "MeshPointId", VTK_ID_TYPE, 1, 0.0, points - 1.0);
  vtkPointData* corners = filter->GetCorners()->GetPointData();
  ExpectArray(corners, "Valence", VTK_INT, 1, 0.0, 20.0);
  const int largest = static_cast<int>(corners->GetArray("Valence")->GetRange()[1]);
  ExpectArray(corners, "CurveIds", VTK_INT, largest, -1.0, count - 1.0);
  ExpectArray(corners, "CornerKind", VTK_UNSIGNED_CHAR, 1, 0.0, 3.0);
  ExpectArray(corners, "Tip", VTK_UNSIGNED_CHAR, 1, 0.0, 1.0);
  ExpectArray(corners, "MeshPointId", VTK_ID_TYPE, 1, 0.0, points - 1.0);
  ExpectArray(filter->GetSurfaces()->GetCellData(), "SurfaceId", VTK_INT, 1, 0.0, faces - 1.0);
}
