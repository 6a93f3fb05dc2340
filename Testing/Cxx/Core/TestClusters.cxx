// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Robust/Clusters.h"

#include "Meshes.h"

#include <gtest/gtest.h>

using namespace arris;
using namespace arris::testing;

namespace
{
constexpr Index Width = 30;

/// The vertex of a flat grid that many edges along its middle row.
Index At(Index column)
{
  return (Width / 2) * (Width + 1) + column;
}

std::vector<std::vector<Index>> Plain(const Rows& rows)
{
  std::vector<std::vector<Index>> plain;
  for (Index row = 0; row < rows.size(); ++row)
  {
    plain.emplace_back(rows[row].begin(), rows[row].end());
  }
  return plain;
}

class ClustersOnAGrid : public ::testing::Test
{
protected:
  const Connectivity Around = Connectivity(FlatGrid(Width, Width));
  Clusters Found = Clusters(Around);
};
}

TEST_F(ClustersOnAGrid, AreThreeEdgesApart)
{
  using Groups = std::vector<std::vector<Index>>;
  for (const Index apart : { 0, 1, 2, 3, 4 })
  {
    this->Found.Clear();
    this->Found.Add({ At(10) });
    this->Found.Add({ At(10 + apart) });
    EXPECT_EQ(
      Plain(this->Found.Find()), apart < 3 ? Groups({ { 0, 1 } }) : Groups({ { 0 }, { 1 } }))
      << apart << " edges apart";
  }
}

TEST_F(ClustersOnAGrid, AreJoinedByWhatComesBetween)
{
  using Groups = std::vector<std::vector<Index>>;
  this->Found.Add({ At(4), At(5) });
  this->Found.Add({ At(20) });
  this->Found.Add({ At(9) });
  this->Found.Add({ At(7) });
  EXPECT_EQ(Plain(this->Found.Find()), Groups({ { 0, 2, 3 }, { 1 } }));
  EXPECT_TRUE(this->Found.MayMove(At(9), 0));
  EXPECT_FALSE(this->Found.MayMove(At(9), 1));
  EXPECT_TRUE(this->Found.MayMove(At(20), 1));
  EXPECT_FALSE(this->Found.MayMove(At(8), 0)) << "which is in none";
  EXPECT_FALSE(this->Found.MayMove(At(15), 1));
}

TEST_F(ClustersOnAGrid, AreNoneOfNoSets)
{
  EXPECT_EQ(this->Found.Find().size(), 0);
}
