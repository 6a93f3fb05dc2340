// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Predictor.h"
#include "Core/Robust/MeetSheets.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace arris;

namespace
{
/// Where planes meet as the predictor tells it.
Vec3 ByPredictor(
  const Vec3& start, const std::vector<Vec3>& points, const std::vector<Vec3>& normals, int most)
{
  Predictor predictor(start);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    predictor.AddPlane(points[i], normals[i], 1.0);
  }
  return predictor.Position(std::numeric_limits<double>::max(), most);
}
}

TEST(MeetSheets, OfPlanesIsWhatThePredictorTells)
{
  std::mt19937 random(5);
  std::normal_distribution<double> anyhow;
  const auto any = [&] { return Vec3(anyhow(random), anyhow(random), anyhow(random)); };
  for (int round = 0; round < 3000; ++round)
  {
    const std::size_t count = 1 + round % 4;
    // Every third time the planes are nearly one, some of them the other way round.
    const double spread = round % 3 == 0 ? 0.1 : 1.0;
    const Vec3 common = any();
    std::vector<Vec3> points, normals;
    std::vector<Sheet> planes;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double side = anyhow(random) < 0.0 ? -1.0 : 1.0;
      points.push_back(0.1 * any());
      normals.push_back(side * (common + spread * any()).normalized());
      planes.emplace_back(points.back(), normals.back());
    }
    std::vector<const Sheet*> sheets;
    for (const Sheet& plane : planes)
    {
      sheets.push_back(&plane);
    }
    const Vec3 start = any();
    const int most = round % 5 == 0 ? 2 : 3;
    const Vec3 expected = ByPredictor(start, points, normals, most);
    // The worst systems that are not cut have a condition of 200.
    EXPECT_LT((MeetSheets(start, sheets, most) - expected).norm(), 1e-11) << "round " << round;
  }
}
