// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeetSheets.h"

#include "Core/Geometry.h"
#include "Core/Predictor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris
{
Vec3 MeetSheets(const Vec3& start, const std::vector<const Sheet*>& sheets, int most)
{
  constexpr int Steps = 6;
  Vec3 point = start;
  for (int step = 0; step < Steps; ++step)
  {
    // Each step solves for the planes that touch the sheets below the point, about `start` where
    // they leave it free: the predictor of the paper with the sheets for its triangles.
    Predictor predictor(point);
    for (const Sheet* sheet : sheets)
    {
      const Vec3 normal = sheet->Normal(point);
      predictor.AddPlane(point - sheet->Distance(point) * normal, normal, 1.0);
    }
    const Vec3 next = predictor.Position(std::numeric_limits<double>::max(), most);
    const double moved = (next - point).norm();
    point = next;
    if (moved <= 1e-12 * (point - start).norm())
    {
      break;
    }
  }
  return point;
}

bool IsSpokenFor(const Sheet& sheet, const std::vector<const Sheet*>& others, const Vec3& point)
{
  const double like = std::cos(LeastCrossingAngle * Pi / 180.0);
  const Vec3 normal = sheet.Normal(point);
  return std::any_of(others.begin(), others.end(),
    [&](const Sheet* other) { return other->Normal(point).dot(normal) > like; });
}
}
