// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Accuracy.h"

#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>

using namespace arris::testing;

namespace
{
Eigen::Vector3d PointOf(vtkPolyData* mesh, vtkIdType id)
{
  Eigen::Vector3d point;
  mesh->GetPoint(id, point.data());
  return point;
}

/// How many triangles have an angle under one degree.
int CountSlivers(vtkPolyData* mesh)
{
  constexpr double Least = 1.0;
  int slivers = 0;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(t, size, ids);
    double smallest = 180.0;
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d u = PointOf(mesh, ids[(k + 1) % 3]) - PointOf(mesh, ids[k]);
      const Eigen::Vector3d w = PointOf(mesh, ids[(k + 2) % 3]) - PointOf(mesh, ids[k]);
      smallest =
        std::min(smallest, vtkMath::DegreesFromRadians(std::atan2(u.cross(w).norm(), u.dot(w))));
    }
    slivers += smallest < Least ? 1 : 0;
  }
  return slivers;
}

vtkIdType CountOpenEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->Update();
  return edges->GetOutput()->GetNumberOfLines();
}

double Volume(vtkPolyData* mesh)
{
  double volume = 0.0;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(t, size, ids);
    volume += PointOf(mesh, ids[0]).dot(PointOf(mesh, ids[1]).cross(PointOf(mesh, ids[2]))) / 6.0;
  }
  return volume;
}

vtkSmartPointer<vtkPolyData> TurnEveryThirdCell(vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> cells;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(t, size, ids);
    const int second = t % 3 == 0 ? 2 : 1;
    cells->InsertNextCell({ ids[0], ids[second], ids[3 - second] });
  }
  const auto turned = vtkSmartPointer<vtkPolyData>::New();
  turned->SetPoints(mesh->GetPoints());
  turned->SetPolys(cells);
  return turned;
}

double Flips(vtkPolyData* mesh)
{
  return mesh->GetFieldData()->GetArray("EdgeFlips")->GetComponent(0, 0);
}

vtkIdType CountChangedCells(vtkPolyData* before, vtkPolyData* after, bool& insideRegion)
{
  vtkDataArray* region = after->GetPointData()->GetArray("SharpRegion");
  vtkIdType changed = 0;
  for (vtkIdType t = 0; t < before->GetNumberOfCells(); ++t)
  {
    vtkIdType size = 0;
    const vtkIdType *was = nullptr, *is = nullptr;
    before->GetPolys()->GetCellAtId(t, size, was);
    after->GetPolys()->GetCellAtId(t, size, is);
    if (std::equal(was, was + 3, is))
    {
      continue;
    }
    ++changed;
    insideRegion = insideRegion &&
      std::all_of(is, is + 3, [&](vtkIdType v) { return region->GetComponent(v, 0) == 1.0; });
  }
  return changed;
}
}

// Contours of 40 samples a side have slivers in their chamfers that sharpening leaves as good as
// without area.
class EdgeFlips : public ::testing::TestWithParam<Model>
{
};

TEST_P(EdgeFlips, MakeRoomInsideTheSharpRegion)
{
  const auto before = Contour(GetParam().Make(), 40);
  vtkNew<vtkSharpEdgeReconstruction> recovery;
  vtkNew<vtkPolyData> off;
  off->DeepCopy(Execute(recovery, before));
  EXPECT_EQ(Flips(off), 0.0);
  bool inside = true;
  EXPECT_EQ(CountChangedCells(before, off, inside), 0);

  recovery->AllowEdgeFlipsOn();
  const auto on = Execute(recovery, before);
  EXPECT_GT(Flips(on), 0.0);
  EXPECT_GT(CountChangedCells(before, on, inside), 0);
  EXPECT_TRUE(inside) << "cells outside the sharp region have changed";
  EXPECT_EQ(on->GetNumberOfPoints(), before->GetNumberOfPoints());
  EXPECT_EQ(CountOpenEdges(on), 0);
  EXPECT_LE(CountSlivers(on), CountSlivers(off));
  EXPECT_LE(CountSlivers(on), CountSlivers(before)) << "the contour has some in its faces";
}

INSTANTIATE_TEST_SUITE_P(Solids, EdgeFlips,
  ::testing::Values(Model{ "Cylinder", CylinderSolid, 0.0 }, Model{ "Bracket", BracketSolid, 0.0 }),
  ModelName);

TEST(EdgeFlipsOfTurnedCells, WindCellsAsTheyWere)
{
  const auto before = Contour(CylinderSolid(), 40);
  vtkNew<vtkSharpEdgeReconstruction> recovery;
  recovery->AllowEdgeFlipsOn();
  vtkNew<vtkPolyData> plain;
  plain->DeepCopy(Execute(recovery, before));
  ASSERT_GT(Flips(plain), 0.0);

  const auto turned = TurnEveryThirdCell(before);
  const auto after = Execute(recovery, turned);
  ASSERT_GT(Flips(after), 0.0);
  EXPECT_NEAR(Volume(TurnEveryThirdCell(after)), Volume(plain), 1e-3 * Volume(plain));
}
