// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// A few meshes of the accuracy bed, small ones: what the robust method reaches on them must not be
/// lost unseen. Testing/Accuracy/Bed/guard.py makes the data; the bed itself tells far more.

#include "Distances.h"

#include <vtkFieldData.h>
#include <vtkXMLPolyDataReader.h>

using namespace arris::testing;

namespace
{
/// What was reached when this was written, in percent, less the slack: two points for one curve or
/// corner that another compiler's rounding may win or lose on meshes as coarse as these (each has
/// some forty edges' length along its shortest curve, of several hundred in all).
struct Guarded
{
  const char* Name;
  double Reach; ///< in cells; what the sampling itself is off by
  double Recall;
  double Precision;
};
constexpr double Slack = 2.0;

std::ostream& operator<<(std::ostream& os, const Guarded& guarded)
{
  return os << guarded.Name;
}

vtkSmartPointer<vtkPolyData> Read(const std::string& name)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((std::string(ARRIS_TEST_DATA) + "/Bed/" + name + ".vtp").c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Points along the lines, each standing for the same length as nearly as may be.
std::vector<Point3> PointsAlong(vtkPolyData* lines, double step)
{
  std::vector<Point3> points;
  for (vtkIdType c = 0; c < lines->GetNumberOfCells(); ++c)
  {
    vtkPoints* ends = lines->GetCell(c)->GetPoints();
    Point3 a, b;
    ends->GetPoint(0, a.data());
    ends->GetPoint(1, b.data());
    const double length = std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
    const int count = std::max(1, static_cast<int>(length / step));
    for (int k = 0; k < count; ++k)
    {
      const double t = (k + 0.5) / count;
      points.push_back(
        { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) });
    }
  }
  return points;
}

double PercentNear(const std::vector<Point3>& points, vtkPolyData* lines, double reach)
{
  DistanceTo distance(lines);
  const auto near = std::count_if(
    points.begin(), points.end(), [&](const Point3& p) { return distance(p) <= reach; });
  return 100.0 * static_cast<double>(near) / static_cast<double>(points.size());
}

class BedGuard : public ::testing::TestWithParam<Guarded>
{
protected:
  vtkSmartPointer<vtkPolyData> Before = Read(GetParam().Name);
  vtkSmartPointer<vtkPolyData> Truth = Read(GetParam().Name + std::string("-edges"));
  double Cell = this->Truth->GetFieldData()->GetArray("Cell")->GetComponent(0, 0);
};
}

TEST_P(BedGuard, AccuracyHolds)
{
  vtkNew<vtkSharpEdgeReconstruction> recovery;
  const auto after = Execute(recovery, this->Before);
  const auto found = SharpMeshEdges(after);
  ASSERT_GT(found->GetNumberOfCells(), 0);
  const double step = 0.1 * this->Cell;
  const double reach = GetParam().Reach * this->Cell;
  const double recall = PercentNear(PointsAlong(this->Truth, step), found, reach);
  const double precision = PercentNear(PointsAlong(found, step), this->Truth, reach);
  EXPECT_GE(recall, GetParam().Recall - Slack);
  EXPECT_GE(precision, GetParam().Precision - Slack);
  RecordProperty("recall", std::to_string(recall));
  RecordProperty("precision", std::to_string(precision));
}

// random0 was 90.8 and 81.9 before vertices tried the faces near them, which is worth four points
// of precision on twelve random parts in the mean; on this one, rounded to single precision, it is
// not.
INSTANTIATE_TEST_SUITE_P(Meshes, BedGuard,
  ::testing::Values(Guarded{ "l_bracket-contour64", 0.1, 99.0, 98.2 },
    Guarded{ "random0-contour64", 0.1, 88.6, 77.1 },
    Guarded{ "pyramid6-irregular32", 0.1, 100.0, 99.4 },
    Guarded{ "fading-contour32", 0.1, 96.1, 87.1 },
    Guarded{ "box_rotated-segmentation32", 0.5, 100.0, 97.8 }),
  [](const ::testing::TestParamInfo<Guarded>& test)
  {
    std::string name = test.param.Name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });
