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
namespace
{
/// The plane that touches a sheet below a point.
struct Tangent
{
  Vec3 Normal;
  double Distance; ///< of the point from it
};

/// The step that leads onto a tangent, or onto two, or between two that are nearly one.
Vec3 StepOnto(const Tangent& a)
{
  return -a.Distance * a.Normal;
}
Vec3 StepOnto(const Tangent& a, const Tangent& b)
{
  const double cosine = a.Normal.dot(b.Normal);
  const double across = 1.0 - std::abs(cosine), along = 1.0 + std::abs(cosine); // eigenvalues
  const double side = cosine < 0.0 ? -1.0 : 1.0;
  if (across <= Predictor::SmallEigenvalue * along)
  {
    return -(a.Distance + side * b.Distance) / (2.0 * along) * (a.Normal + side * b.Normal);
  }
  const double determinant = across * along;
  return ((cosine * b.Distance - a.Distance) * a.Normal +
           (cosine * a.Distance - b.Distance) * b.Normal) /
    determinant;
}

/// Where the tangents meet, about `point` where they leave it free: what the predictor of the paper
/// says of them, in closed form where that is well determined.
Vec3 MeetTangents(const Vec3& point, const std::vector<Tangent>& tangents, int most)
{
  if (tangents.size() == 1)
  {
    return point + StepOnto(tangents[0]);
  }
  if (tangents.size() == 2)
  {
    return point + StepOnto(tangents[0], tangents[1]);
  }
  if (tangents.size() == 3 && most == 3)
  {
    // The product of the eigenvalues, of which the larger two have at most the sum of all, 3, and
    // so the product 9/4.
    const Tangent &a = tangents[0], &b = tangents[1], &c = tangents[2];
    const Vec3 bc = b.Normal.cross(c.Normal);
    const double volume = a.Normal.dot(bc);
    if (volume * volume > 2.25 * 3.0 * Predictor::SmallEigenvalue)
    {
      return point -
        (a.Distance * bc + b.Distance * c.Normal.cross(a.Normal) +
          c.Distance * a.Normal.cross(b.Normal)) /
        volume;
    }
  }
  Predictor predictor(point);
  for (const Tangent& tangent : tangents)
  {
    predictor.AddPlane(point - tangent.Distance * tangent.Normal, tangent.Normal, 1.0);
  }
  return predictor.Position(std::numeric_limits<double>::max(), most);
}
}

Vec3 MeetSheets(const Vec3& start, const std::vector<const Sheet*>& sheets, int most)
{
  constexpr int Steps = 6;
  const bool flat =
    std::all_of(sheets.begin(), sheets.end(), [](const Sheet* sheet) { return sheet->IsFlat(); });
  std::vector<Tangent> tangents(sheets.size());
  Vec3 point = start;
  for (int step = 0; step < Steps; ++step)
  {
    for (std::size_t i = 0; i < sheets.size(); ++i)
    {
      tangents[i] = { sheets[i]->Normal(point), sheets[i]->Distance(point) };
    }
    const Vec3 next = MeetTangents(point, tangents, most);
    const double moved = (next - point).norm();
    point = next;
    if (flat || moved <= 1e-12 * (point - start).norm())
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
