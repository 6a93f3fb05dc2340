// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Mending.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

// A vertex that an earlier pass has put too far away, and that is not damaged any more.
TEST(Mending, TurnsBackAfterTheLastPassWhatAnEarlierOneHasTurnedOver)
{
  constexpr Index Width = 8;
  constexpr Index Middle = MiddleOfGrid(Width);
  const Mesh before = FlatGrid(Width, Width);
  Mesh now = before;
  now.Points[Middle].x() += 1.5;
  const Connectivity around(before);
  Labelling labels;
  labels.Labels.assign(before.Points.size(), NoIndex);
  labels.SidesOf.assign(before.Points.size(), NoIndex);
  const std::vector<double> scales(before.Points.size(), 1.0);
  const Flags region(before.Points.size(), 0);
  const Labelled mesh{ before, now, now, around, labels, scales, region };
  for (const bool isLast : { false, true })
  {
    Placement placement(
      now, around, labels, scales, std::vector<Index>(before.Triangles.size(), NoIndex));
    Mend(mesh, {}, { false, false, isLast, {} }, placement);
    EXPECT_EQ(placement.AllPoints(), isLast ? before.Points : now.Points);
  }
}
