// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Distances.h"

#include <vtkMetaImageReader.h>
#include <vtkPLYReader.h>
#include <vtkXMLPolyDataReader.h>

using namespace arris::testing;

// The whole pipeline on the real part under Data/: volume, contour, recovery, features.

namespace
{
std::string DataFile(const char* name)
{
  return std::string(ARRIS_DATA) + "/" + name;
}

vtkSmartPointer<vtkPolyData> ContourOfVolume(const char* file)
{
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(DataFile(file).c_str());
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(reader->GetOutputPort());
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->Update();
  return contour->GetOutput();
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> Read(const char* file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(DataFile(file).c_str());
  reader->Update();
  return reader->GetOutput();
}

std::vector<Point3> PointsOf(vtkPolyData* data)
{
  std::vector<Point3> points(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, points[i].data());
  }
  return points;
}

vtkIdType Count(vtkPolyData* data, const char* name, double value)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    count += array->GetComponent(i, 0) == value ? 1 : 0;
  }
  return count;
}

double LongestDisplacement(vtkPolyData* data)
{
  vtkDataArray* displacement = data->GetPointData()->GetArray("Displacement");
  return displacement->GetRange(-1)[1]; // of the magnitude
}
}

TEST(Bracket, ContoursAreWhatTheDataSay)
{
  // The counts in Data/README.md, exactly: the numbers below mean nothing on another input.
  const auto coarse = ContourOfVolume("bracket-small.mha");
  EXPECT_EQ(coarse->GetNumberOfPoints(), 5952);
  EXPECT_EQ(coarse->GetNumberOfPolys(), 11924);
  const auto fine = ContourOfVolume("bracket.mha");
  EXPECT_EQ(fine->GetNumberOfPoints(), 54090);
  EXPECT_EQ(fine->GetNumberOfPolys(), 108200);
}

TEST(Bracket, IsRecoveredByThePaper)
{
  const auto before = ContourOfVolume("bracket.mha");
  const auto after = RecoverByPaper(before);
  ASSERT_EQ(after->GetNumberOfPoints(), before->GetNumberOfPoints());
  ExpectSameCells(after->GetPolys(), before->GetPolys(), "triangles");

  // 6877 and 3517 now. A tenth either way: other rounding or order changes a few vertices, another
  // rule many.
  const vtkIdType sharp = Count(after, "SharpRegion", 1.0);
  EXPECT_NEAR(static_cast<double>(sharp), 6877.0, 690.0);
  const vtkIdType skeleton = after->GetNumberOfPoints() - Count(after, "SkeletonRole", 0.0);
  EXPECT_NEAR(static_cast<double>(skeleton), 3517.0, 350.0);

  // 3.2 times nearer now; asked is two. At one point a triangle: they are small here.
  DistanceTo truth(Read<vtkPLYReader>("bracket.ply"));
  EXPECT_LE(MeanDistance<1>(after, truth), 0.5 * MeanDistance<1>(before, truth));

  // Cells are 1 mm wide.
  const std::vector<Point3> edges = PointsOf(Read<vtkXMLPolyDataReader>("bracket-edges.vtp"));
  ASSERT_EQ(edges.size(), 11600u);
  EXPECT_LE(Recall(before, edges, 0.1), 0.2);
  EXPECT_GE(Recall(after, edges, 0.1), 0.72);
}

TEST(Bracket, CoarseOneComesThroughWhole)
{
  // Walls of two cells: the sharp region swallows a third of it, and the paper's method is no help
  // there (Data/README.md warns). So only that nothing breaks, and that no vertex leaves farther
  // than its predictor may, four average edges from its neighbours, who are no farther than one or
  // two from it themselves.
  const auto before = ContourOfVolume("bracket-small.mha");
  const auto after = RecoverByPaper(before);
  ASSERT_EQ(after->GetNumberOfPoints(), before->GetNumberOfPoints());
  const double edge = after->GetFieldData()->GetArray("AverageEdgeLength")->GetComponent(0, 0);
  EXPECT_LE(LongestDisplacement(after), 6.0 * edge);
  for (const Point3& p : PointsOf(after))
  {
    ASSERT_TRUE(p.allFinite());
  }
  EXPECT_NEAR(static_cast<double>(Count(after, "SharpRegion", 1.0)), 2359.0, 240.0);
}

TEST(Bracket, FeatureCurvesAreAsLongAsTheTrueEdges)
{
  vtkNew<vtkSharpEdgeExtractor> extractor;
  const auto curves = Execute(extractor, RecoverByPaper(ContourOfVolume("bracket.mha")));
  double length = 0.0;
  for (vtkIdType i = 0; i < curves->GetNumberOfCells(); ++i)
  {
    length += curves->GetCellData()->GetArray("Length")->GetComponent(i, 0);
  }
  // 2897 mm in truth. The paper's false joints and tails add to what is found.
  std::cout << "length " << length << std::endl;
  EXPECT_GE(length, 0.8 * 2897.4);
  EXPECT_LE(length, 2.0 * 2897.4);
}
