// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Distances.h"

#include <vtkFieldData.h>

using namespace arris::testing;

// What people segment: voxels inside or outside, smoothed a little, contoured. Faces come with
// terraces up to half a cell off, so that edges are asked for that near; their positions are no
// better.

namespace
{
constexpr int Samples = 64;

struct Segmented
{
  const char* Name;
  Solid (*Make)();
  double LeastRecall;
};
std::ostream& operator<<(std::ostream& os, const Segmented& segmented)
{
  return os << segmented.Name;
}

class SegmentedSolid : public ::testing::TestWithParam<Segmented>
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
  EXPECT_GE(found, GetParam().LeastRecall);
}

// Of the prism with edges of 40 degrees, thresholds that suit noise find 67 %.
INSTANTIATE_TEST_SUITE_P(Solids, SegmentedSolid,
  ::testing::Values(Segmented{ "Box", BoxSolid, 0.95 },
    Segmented{ "Nonagon", [] { return RegularPrism(9); }, 0.9 },
    Segmented{ "Cylinder", CylinderSolid, 0.95 }),
  [](const ::testing::TestParamInfo<Segmented>& test) { return test.param.Name; });
