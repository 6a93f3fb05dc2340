// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CurveCoverage.h"

#include "Segments.h"

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace arris
{
namespace
{
using Point = Eigen::Vector3d;
using Segment = std::array<Point, 2>;

std::vector<Segment> SegmentsOf(vtkPolyData* curves)
{
  std::vector<Segment> segments;
  ForEachSegment(curves,
    [&](vtkIdType a, vtkIdType b)
    {
      Segment segment;
      curves->GetPoint(a, segment[0].data());
      curves->GetPoint(b, segment[1].data());
      if (segment[0] != segment[1])
      {
        segments.push_back(segment);
      }
    });
  return segments;
}

/// The segments one cell each: a locator finds them faster than long polylines.
vtkSmartPointer<vtkPolyData> CellsOf(const std::vector<Segment>& segments)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const Segment& segment : segments)
  {
    const vtkIdType a = points->InsertNextPoint(segment[0].data());
    const vtkIdType b = points->InsertNextPoint(segment[1].data());
    lines->InsertNextCell({ a, b });
  }
  auto cells = vtkSmartPointer<vtkPolyData>::New();
  cells->SetPoints(points);
  cells->SetLines(lines);
  return cells;
}
}

double CurveCoverage(vtkPolyData* curves, vtkPolyData* others, double distance)
{
  const std::vector<Segment> segments = SegmentsOf(curves);
  const std::vector<Segment> otherSegments = SegmentsOf(others);
  if (segments.empty() || otherSegments.empty())
  {
    return 0.0;
  }
  const vtkSmartPointer<vtkPolyData> cells = CellsOf(otherSegments);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(cells);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;

  // The middles of pieces a quarter of the distance long stand for their pieces.
  const double longestPiece = 0.25 * distance;
  double length = 0.0;
  double covered = 0.0;
  for (const Segment& segment : segments)
  {
    const double whole = (segment[1] - segment[0]).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(whole / longestPiece)));
    for (int i = 0; i < pieces; ++i)
    {
      Point middle = segment[0] + (i + 0.5) / pieces * (segment[1] - segment[0]);
      Point nearest;
      vtkIdType id = -1;
      int part = 0;
      double squared = 0.0;
      const bool near = locator->FindClosestPointWithinRadius(
                          middle.data(), distance, nearest.data(), cell, id, part, squared) == 1;
      length += whole / pieces;
      covered += near ? whole / pieces : 0.0;
    }
  }
  return covered / length;
}
}
