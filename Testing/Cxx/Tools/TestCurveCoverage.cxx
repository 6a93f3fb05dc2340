// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CurveCoverage.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include <vector>

using arris::CurveCoverage;

namespace
{
constexpr double Distance = 0.1;
constexpr double Rounding = 1e-12;

vtkSmartPointer<vtkPolyData> Polyline(const std::vector<Eigen::Vector3d>& vertices)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(vertices.size()));
  for (const Eigen::Vector3d& vertex : vertices)
  {
    lines->InsertCellPoint(points->InsertNextPoint(vertex.data()));
  }
  auto curves = vtkSmartPointer<vtkPolyData>::New();
  curves->SetPoints(points);
  curves->SetLines(lines);
  return curves;
}

/// From (0, y) to (length, y), in two pieces.
vtkSmartPointer<vtkPolyData> Line(double length, double y = 0.0)
{
  return Polyline({ { 0.0, y, 0.0 }, { 0.3 * length, y, 0.0 }, { length, y, 0.0 } });
}
}

TEST(CurveCoverage, OfItselfIsAll)
{
  const auto corner = Polyline({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 } });
  EXPECT_NEAR(CurveCoverage(corner, corner, Distance), 1.0, Rounding);
}

TEST(CurveCoverage, OfHalfALine)
{
  // Covered is the half that both have, and as much of the rest as the distance reaches.
  EXPECT_NEAR(CurveCoverage(Line(2.0), Line(1.0), Distance), (1.0 + Distance) / 2.0, Distance / 8);
  EXPECT_NEAR(CurveCoverage(Line(1.0), Line(2.0), Distance), 1.0, Rounding);
}

TEST(CurveCoverage, ParallelLinesBothSidesOfTheDistance)
{
  EXPECT_NEAR(CurveCoverage(Line(1.0), Line(1.0, 0.99 * Distance), Distance), 1.0, Rounding);
  EXPECT_EQ(CurveCoverage(Line(1.0), Line(1.0, 1.01 * Distance), Distance), 0.0);
}

TEST(CurveCoverage, CountsLengthAndNotSegments)
{
  // Three short segments near the other line, and a long one that leads away from it.
  const auto curves =
    Polyline({ { 0, 0, 0 }, { 0.3, 0, 0 }, { 0.6, 0, 0 }, { 1, 0, 0 }, { 1, 9, 0 } });
  EXPECT_NEAR(CurveCoverage(curves, Line(1.0), Distance), (1.0 + Distance) / 10.0, Distance / 80);
}

TEST(CurveCoverage, OfNothingIsNothing)
{
  const auto nothing = vtkSmartPointer<vtkPolyData>::New();
  const auto point = Polyline({ { 0, 0, 0 }, { 0, 0, 0 } });
  for (const auto& empty : { nothing, point })
  {
    EXPECT_EQ(CurveCoverage(empty, Line(1.0), Distance), 0.0);
    EXPECT_EQ(CurveCoverage(Line(1.0), empty, Distance), 0.0);
  }
}
