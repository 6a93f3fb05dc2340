// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Flagged.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 6;
constexpr Index Middle = MiddleOfGrid(Width);
const Mesh Grid = FlatGrid(Width, Width);
const Connectivity Around(Grid);
}

TEST(Flagged, KeepTheirOrder)
{
  EXPECT_EQ(Flagged({ 0, 1, 1, 0, 1 }), (std::vector<Index>{ 1, 2, 4 }));
  const std::vector<Index> items = { 9, 4, 7, 2, 4 };
  EXPECT_EQ(Those(items, [](Index i) { return i % 2 == 0; }), (std::vector<Index>{ 4, 2, 4 }));
  EXPECT_TRUE(Those(items, [](Index) { return false; }).empty());
}

TEST(Flagged, KnowHowFarOthersAre)
{
  Flags flags(Grid.Points.size(), 0);
  flags[Middle] = 1;
  const std::vector<int> away = EdgesAwayFrom(Around, flags, 2);
  EXPECT_EQ(away[Middle], 0);
  EXPECT_EQ(away[Middle + 1], 1);
  EXPECT_EQ(away[Middle + Width + 2], 1) << "the diagonal";
  EXPECT_EQ(away[Middle - Width], 2) << "across the other diagonal";
  EXPECT_EQ(away[Middle + 3], -1);
}

TEST(Flagged, ComeInConnectedGroups)
{
  Flags flags(Grid.Points.size(), 0);
  flags[Middle] = flags[Middle + 1] = flags[0] = 1;
  std::vector<std::vector<Index>> groups;
  ForEachGroup(Around, flags, 1, [&](const std::vector<Index>& group) { groups.push_back(group); });
  EXPECT_EQ(groups, (std::vector<std::vector<Index>>{ { 0 }, { Middle, Middle + 1 } }));
}
