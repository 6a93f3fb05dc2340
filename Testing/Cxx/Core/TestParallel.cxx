// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Parallel.h"

#include <gtest/gtest.h>

#include <atomic>

using namespace arris;

namespace
{
constexpr Index Many = 1500000; // more than one slab
}

TEST(Parallel, CoversEachIndexOnce)
{
  for (const Index count : { 0, 1, 19999, 20000, 20001, Many })
  {
    std::vector<unsigned char> visits(count, 0);
    EXPECT_TRUE(ParallelFor(count, Monitor(),
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          ++visits[i];
        }
      }));
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), count);
  }
}

TEST(Parallel, StopsWhenTheMonitorSaysSo)
{
  std::atomic<Index> done(0);
  int reports = 0;
  const Monitor monitor([&](double) { return ++reports < 3; });
  EXPECT_FALSE(ParallelFor(Many, monitor, [&](Index begin, Index end) { done += end - begin; }));
  EXPECT_GT(done, 0);
  EXPECT_LT(done, Many / 2) << "two of many slabs";
}

TEST(Parallel, AStopAtTheVeryEndCountsAsWell)
{
  const Monitor monitor([](double fraction) { return fraction < 1.0; });
  EXPECT_FALSE(ParallelFor(10, monitor, [](Index, Index) {}));
}

TEST(Parallel, ReportsFractionsThatRiseFromZeroToOne)
{
  std::vector<double> reports;
  const Monitor monitor(
    [&](double fraction)
    {
      reports.push_back(fraction);
      return true;
    });
  ParallelFor(Many, monitor, [](Index, Index) {});
  EXPECT_EQ(reports.front(), 0.0);
  EXPECT_EQ(reports.back(), 1.0);
  EXPECT_GT(reports.size(), 10u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
}

TEST(Monitor, PartsNestIntoTheirWhole)
{
  double reported = -1.0;
  const Monitor whole(
    [&](double fraction)
    {
      reported = fraction;
      return true;
    });
  const Monitor part = whole.Part(0.5, 0.9).Part(0.25, 0.75);
  part.Report(0.0);
  EXPECT_DOUBLE_EQ(reported, 0.6);
  part.Report(1.0);
  EXPECT_DOUBLE_EQ(reported, 0.8);
}

TEST(Monitor, WithoutAListenerNeverStops)
{
  EXPECT_TRUE(Monitor().Report(0.5));
}
