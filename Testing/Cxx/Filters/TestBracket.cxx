// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Distances.h"

#include <vtkExtractVOI.h>
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

/// Of every `stride`-th sample of a volume.
vtkSmartPointer<vtkPolyData> ContourOfVolume(const char* file, int stride = 1)
{
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(DataFile(file).c_str());
  reader->Update();
  vtkNew<vtkExtractVOI> samples;
  samples->SetInputConnection(reader->GetOutputPort());
  samples->SetVOI(reader->GetOutput()->GetExtent());
  samples->SetSampleRate(stride, stride, stride);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(samples->GetOutputPort());
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
  EXPECT_EQ(coarse->GetNumberOfPoints(), 8008);
  EXPECT_EQ(coarse->GetNumberOfPolys(), 16028);
  const auto half = ContourOfVolume("bracket.mha", 2);
  EXPECT_EQ(half->GetNumberOfPoints(), 18064);
  EXPECT_EQ(half->GetNumberOfPolys(), 36140);
  const auto fine = ContourOfVolume("bracket.mha");
  EXPECT_EQ(fine->GetNumberOfPoints(), 72408);
  EXPECT_EQ(fine->GetNumberOfPolys(), 144828);
}

namespace
{
struct Sampling
{
  const char* Name;
  int Stride; // and the cell's width in millimetres
  double Sharp;
  double Skeleton;
};
std::ostream& operator<<(std::ostream& os, const Sampling& sampling)
{
  return os << sampling.Name;
}
class SampledBracket : public ::testing::TestWithParam<Sampling>
{
};
}

TEST_P(SampledBracket, IsRecoveredByThePaper)
{
  const auto before = ContourOfVolume("bracket.mha", GetParam().Stride);
  const auto after = RecoverByPaper(before);
  ASSERT_EQ(after->GetNumberOfPoints(), before->GetNumberOfPoints());
  ExpectSameCells(after->GetPolys(), before->GetPolys(), "triangles");

  // A tenth either way: other rounding or order changes a few vertices, another rule many.
  const auto sharp = static_cast<double>(Count(after, "SharpRegion", 1.0));
  EXPECT_NEAR(sharp, GetParam().Sharp, 0.1 * GetParam().Sharp);
  const auto skeleton =
    static_cast<double>(after->GetNumberOfPoints() - Count(after, "SkeletonRole", 0.0));
  EXPECT_NEAR(skeleton, GetParam().Skeleton, 0.1 * GetParam().Skeleton);

  // Promised are half the distance and 72 %. It is 3.8 times nearer and 96 % at full resolution,
  // 3.5 times and 91 % at half; the limits lie between. At one point a triangle: they are small.
  DistanceTo truth(Read<vtkPLYReader>("bracket.ply"));
  EXPECT_LE(MeanDistance<1>(after, truth), MeanDistance<1>(before, truth) / 3.0);
  const std::vector<Point3> edges = PointsOf(Read<vtkXMLPolyDataReader>("bracket-edges.vtp"));
  ASSERT_EQ(edges.size(), 10581u);
  EXPECT_LE(Recall(before, edges, 0.1 * GetParam().Stride), 0.2) << "the contour lost no edges";
  EXPECT_GE(Recall(after, edges, 0.1 * GetParam().Stride), 0.85);

  for (vtkIdType i = 0; i < after->GetNumberOfPoints(); ++i)
  {
    if (after->GetPointData()->GetArray("SharpRegion")->GetComponent(i, 0) == 0.0)
    {
      Point3 was, is;
      before->GetPoint(i, was.data());
      after->GetPoint(i, is.data());
      ASSERT_EQ(was, is) << "an intact vertex moved: " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Resolutions, SampledBracket,
  ::testing::Values(Sampling{ "Full", 1, 6343, 3235 }, Sampling{ "Half", 2, 3115, 1605 }),
  [](const auto& test) { return test.param.Name; });

TEST(Bracket, CoarseOneComesThroughWhole)
{
  // Walls of four cells: a quarter of it is in the sharp region (Data/README.md warns). So only
  // that nothing breaks, and that no vertex leaves farther than its predictor may, four average
  // edges from its neighbours, who are no farther than one or two from it themselves.
  const auto before = ContourOfVolume("bracket-small.mha");
  const auto after = RecoverByPaper(before);
  ASSERT_EQ(after->GetNumberOfPoints(), before->GetNumberOfPoints());
  const double edge = after->GetFieldData()->GetArray("AverageEdgeLength")->GetComponent(0, 0);
  EXPECT_LE(LongestDisplacement(after), 6.0 * edge);
  for (const Point3& p : PointsOf(after))
  {
    ASSERT_TRUE(p.allFinite());
  }
  EXPECT_NEAR(static_cast<double>(Count(after, "SharpRegion", 1.0)), 2137.0, 214.0);
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
  // 3527 mm now, 2644 mm in truth. The paper's false joints and tails add to what is found.
  EXPECT_GE(length, 0.8 * 2644.0);
  EXPECT_LE(length, 2.0 * 2644.0);
}
