// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/ExactSum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace arris;

namespace
{
double SumOf(const std::vector<double>& values)
{
  return ExactSums<1>(
    static_cast<Index>(values.size()), [&](Index i, auto& sums) { sums[0].Add(values[i]); })[0]
    .Value();
}
}

TEST(ExactSum, IsTheSameInAnyOrder)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  std::vector<double> values(5000);
  std::generate(values.begin(), values.end(), [&] { return anywhere(random); });
  const double sum = SumOf(values);
  const double reversed = SumOf({ values.rbegin(), values.rend() });
  std::sort(values.begin(), values.end());
  EXPECT_EQ(sum, reversed);
  EXPECT_EQ(sum, SumOf(values));
}

TEST(ExactSum, LosesNothingAboveAMillionthOfAMillionthOfAMillionth)
{
  // 2^-60 is 0.9e-18; a sum of doubles would lose all of these beside the 1.
  std::vector<double> values(1000, 1e-15);
  values.push_back(1.0);
  values.push_back(-1.0);
  EXPECT_NEAR(SumOf(values), 1e-12, 1000 * 1e-18);
}

TEST(ExactSum, HoldsTheLargestTerms)
{
  const std::vector<double> values(100000, -1.0);
  EXPECT_EQ(SumOf(values), -100000.0);
}

TEST(ExactSum, OfNothingIsZero)
{
  EXPECT_EQ(SumOf({}), 0.0);
}
