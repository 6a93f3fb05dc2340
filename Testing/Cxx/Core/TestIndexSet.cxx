// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/IndexSet.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace arris;

TEST(IndexSet, TellsWhatIsNew)
{
  IndexSet set;
  EXPECT_TRUE(set.Insert(7));
  EXPECT_FALSE(set.Insert(7));
  EXPECT_TRUE(set.Insert(0));
  EXPECT_FALSE(set.Insert(7));
}

TEST(IndexSet, ForgetsWhenCleared)
{
  IndexSet set;
  set.Insert(7);
  set.Clear();
  EXPECT_TRUE(set.Insert(7));
  EXPECT_FALSE(set.Insert(7));
}

TEST(IndexSet, GrowsAndKeepsWhatItHolds)
{
  IndexSet set;
  constexpr Index Count = 100000; // hundreds of times the first table
  for (Index i = 0; i < Count; ++i)
  {
    ASSERT_TRUE(set.Insert(3 * i));
  }
  for (Index i = 0; i < Count; ++i)
  {
    ASSERT_FALSE(set.Insert(3 * i));
  }
}

TEST(IndexSet, GrowingAfterAClearBringsNothingBack)
{
  IndexSet set;
  for (Index i = 0; i < 100; ++i)
  {
    set.Insert(i);
  }
  set.Clear();
  for (Index i = 1000; i < 2000; ++i) // grows, with the cleared entries still in the table
  {
    set.Insert(i);
  }
  for (Index i = 0; i < 100; ++i)
  {
    EXPECT_TRUE(set.Insert(i));
  }
}

TEST(IndexSet, AgreesWithTheStandardSet)
{
  std::mt19937 random(2);
  IndexSet set;
  for (int window = 0; window < 300; ++window)
  {
    set.Clear();
    std::set<Index> expected;
    // A stride of a power of two sends plain masks of the index to the same slot.
    const Index stride = Index(1) << (random() % 20);
    const Index count = static_cast<Index>(random() % 600);
    for (Index i = 0; i < count; ++i)
    {
      const Index value = static_cast<Index>(random() % 500) * stride;
      ASSERT_EQ(set.Insert(value), expected.insert(value).second);
    }
  }
}
