// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Accuracy.h"

using namespace arris::testing;

// A guard of what the robust method, the default, reaches on contours at 64^3, each solid turned
// off the grid. It reaches 100, 100 and 99 % of the sharp edges; 97 % leaves room for a compiler
// that rounds otherwise, not for a step that has stopped working. Planes come back exactly
// (hundreds of times nearer), a cylinder to the facets that its triangles are (2.4 times).

namespace
{
vtkSmartPointer<vtkPolyData> Recover(vtkPolyData* mesh)
{
  vtkNew<vtkSharpEdgeReconstruction> recovery;
  return Execute(recovery, mesh);
}

/// The mesh edges over which two triangles are folded back onto each other.
vtkIdType FoldedEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> folds;
  folds->SetInputData(mesh);
  folds->BoundaryEdgesOff();
  folds->NonManifoldEdgesOff();
  folds->ManifoldEdgesOff();
  folds->FeatureEdgesOn();
  folds->SetFeatureAngle(160.0);
  folds->Update();
  return folds->GetOutput()->GetNumberOfLines();
}
}

using RobustAccuracy = RecoveredModel<Recover>;

TEST_P(RobustAccuracy, ComesNearerToTheTruthInTheMean)
{
  EXPECT_GE(this->Improvement(), GetParam().Least);
}

TEST_P(RobustAccuracy, NearlyAllSharpEdgesAreBack)
{
  EXPECT_LE(this->Found(this->Before), 0.2) << "or the contour did not lose them";
  EXPECT_GE(this->Found(this->After), 0.97);
}

TEST_P(RobustAccuracy, FoldsNothing)
{
  EXPECT_LE(FoldedEdges(this->After), FoldedEdges(this->Before));
}

INSTANTIATE_TEST_SUITE_P(Solids, RobustAccuracy,
  ::testing::Values(Model{ "Box", BoxSolid, 50.0 }, Model{ "Cylinder", CylinderSolid, 2.0 },
    Model{ "Bracket", BracketSolid, 50.0 }),
  ModelName);

// Of tightly curved faces, what has nearly one normal is too narrow to tell a curvature by. Of
// these rims 78 % come back, and 67 % where no more than that is fitted.
TEST(RobustAccuracyOfRods, RimsOfFewCellsComeBack)
{
  constexpr int Samples = 64;
  const double width = CellWidth(Samples);
  double found = 0.0;
  for (const double cells : { 2.3, 2.4, 2.5, 2.6 })
  {
    const Solid rod = RoundSolid(cells * width);
    const auto after = Recover(Contour(rod, Samples));
    const double of = Recall(after, rod.SharpEdgePoints(0.05 * width), 0.1 * width);
    RecordProperty(std::to_string(cells), std::to_string(of));
    found += 0.25 * of;
  }
  RecordProperty("found", std::to_string(found));
  EXPECT_GE(found, 0.72);
}
