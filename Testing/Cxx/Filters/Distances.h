// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Distances.h
/// How near a mesh comes to the truth.

#ifndef arris_testing_Distances_h
#define arris_testing_Distances_h

#include "FilterTesting.h"

#include <vtkFeatureEdges.h>
#include <vtkGenericCell.h>
#include <vtkStaticCellLocator.h>

namespace arris
{
namespace testing
{
/// The mean over the surface of the distance that `distanceAt` gives, each triangle at the centres
/// of `Parts` times `Parts` equal ones.
template <int Parts, typename DistanceAt>
double MeanDistance(vtkPolyData* mesh, DistanceAt&& distanceAt)
{
  double sum = 0.0;
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    Point3 a, b, c;
    mesh->GetPoint(ids->GetId(0), a.data());
    mesh->GetPoint(ids->GetId(1), b.data());
    mesh->GetPoint(ids->GetId(2), c.data());
    const double partArea = 0.5 * (b - a).cross(c - a).norm() / (Parts * Parts);
    for (int i = 0; i < Parts; ++i)
    {
      for (int j = 0; i + j < Parts; ++j)
      {
        for (const double third : { 1.0 / 3.0, 2.0 / 3.0 }) // an upright part, an inverted one
        {
          if (third > 0.5 && i + j + 1 >= Parts)
          {
            continue;
          }
          const double u = (i + third) / Parts;
          const double v = (j + third) / Parts;
          sum += partArea * std::abs(distanceAt(Point3(a + u * (b - a) + v * (c - a))));
          area += partArea;
        }
      }
    }
  }
  return sum / area;
}

/// The distance from points to a surface or to lines.
class DistanceTo
{
public:
  explicit DistanceTo(vtkPolyData* data)
  {
    this->Locator->SetDataSet(data);
    this->Locator->BuildLocator();
  }
  double operator()(const Point3& p)
  {
    double nearest[3];
    vtkIdType cell = 0;
    int part = 0;
    double squared = 0.0;
    this->Locator->FindClosestPoint(p.data(), nearest, this->Cell, cell, part, squared);
    return std::sqrt(squared);
  }

private:
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
};

/// The mesh edges of a dihedral angle above 20 degrees, by VTK's filter and not by ours.
inline vtkSmartPointer<vtkPolyData> SharpMeshEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->SetFeatureAngle(20.0);
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput();
}

/// The part of these points that have a sharp mesh edge within `reach`.
inline double Recall(vtkPolyData* mesh, const std::vector<Point3>& truth, double reach)
{
  const vtkSmartPointer<vtkPolyData> edges = SharpMeshEdges(mesh);
  if (edges->GetNumberOfCells() == 0)
  {
    return 0.0;
  }
  DistanceTo distance(edges);
  const auto found = std::count_if(
    truth.begin(), truth.end(), [&](const Point3& p) { return distance(p) <= reach; });
  return static_cast<double>(found) / static_cast<double>(truth.size());
}
}
}

#endif
