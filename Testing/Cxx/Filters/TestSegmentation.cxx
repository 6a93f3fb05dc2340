// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Accuracy.h"

#include <vtkFieldData.h>

using namespace arris::testing;

// What people segment: voxels inside or outside, smoothed a little, contoured. Faces come with
// terraces up to half a cell off, so that edges are asked for that near; their positions are no
// better.

namespace
{
constexpr int Samples = 64;

class SegmentedSolid : public ::testing::TestWithParam<Model>
{
};
}

TEST_P(SegmentedSolid, GetsItsEdgesBack)
{
  const Solid solid = GetParam().Make();
  const auto before = SegmentedContour(solid, Samples);
  vtkNew<vtkSharpEdgeReconstruction> recovery;
  const auto after = Execute(recovery, before);
  EXPECT_EQ(after->GetFieldData()->GetArray("Roughness")->GetComponent(0, 0), 1.0);
  const double width = CellWidth(Samples);
  const double found = Recall(after, solid.SharpEdgePoints(0.05 * width), 0.5 * width);
  RecordProperty("found", std::to_string(found));
  EXPECT_GE(found, GetParam().Least);
}

// Of the prism with edges of 40 degrees, thresholds that suit noise find 67 %.
INSTANTIATE_TEST_SUITE_P(Solids, SegmentedSolid,
  ::testing::Values(Model{ "Box", BoxSolid, 0.95 },
    Model{ "Nonagon", [] { return RegularPrism(9); }, 0.9 },
    Model{ "Cylinder", CylinderSolid, 0.95 }),
  ModelName);
