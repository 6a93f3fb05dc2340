// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LocalSolid.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris
{
namespace
{
/// The mean distance of samples from a sheet.
double MeanDistance(const std::vector<SheetSample>& samples, const Sheet& sheet)
{
  double sum = 0.0, weights = 0.0;
  for (const SheetSample& sample : samples)
  {
    sum += sample.Weight * sheet.Distance(sample.Position);
    weights += sample.Weight;
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

/// The larger of two distances, or the smaller; what a Gaussian leaves of it is Clark's mean of the
/// greater of two normal variables, as distances are linear across the little that it averages
/// over.
LocalSolid::Value Meeting(
  const LocalSolid::Value& a, const LocalSolid::Value& b, bool larger, double width)
{
  const double sign = larger ? 1.0 : -1.0;
  const double gap = sign * (a.Distance - b.Distance);
  const double spread = width * (a.Normal - b.Normal).norm();
  constexpr double Farthest = 8.0; // spreads, beyond which the other has no part in it
  if (std::abs(gap) >= Farthest * spread)
  {
    return gap >= 0.0 ? a : b;
  }
  const double x = gap / spread;
  const double share = 0.5 * std::erfc(-x / std::sqrt(2.0));
  const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * Pi);
  return { share * a.Distance + (1.0 - share) * b.Distance + sign * spread * density,
    share * a.Normal + (1.0 - share) * b.Normal };
}
}

void LocalSolid::AddSheet(const Sheet& sheet, const std::vector<SheetSample>& samples)
{
  const std::size_t added = this->Sheets.size();
  this->MeanDistances.emplace_back(added + 1, 0.0);
  for (std::size_t other = 0; other < added; ++other)
  {
    this->MeanDistances[added][other] = MeanDistance(samples, this->Sheets[other]);
    this->MeanDistances[other].push_back(MeanDistance(this->Samples[other], sheet));
  }
  this->Sheets.push_back(sheet);
  this->Samples.push_back(samples);
}

double LocalSolid::Distance(const Vec3& point) const
{
  return this->ValueAt(point, 0.0, false).Distance;
}

LocalSolid::Value LocalSolid::ValueAt(const Vec3& point, double width, bool normals) const
{
  Members all;
  std::vector<Value> values;
  for (std::size_t k = 0; k < this->Sheets.size(); ++k)
  {
    all.push_back(static_cast<int>(k));
    values.push_back({ this->Sheets[k].Distance(point),
      normals ? this->Sheets[k].Normal(point) : Vec3(Vec3::Zero()) });
  }
  return this->ValueOf(all, values, width);
}

std::vector<LocalSolid::Members> LocalSolid::Groups(const Members& members, bool convex) const
{
  std::vector<Members> groups;
  Members left = members;
  while (!left.empty())
  {
    Members group(1, left.front());
    left.erase(left.begin());
    for (std::size_t next = 0; next < group.size(); ++next)
    {
      for (std::size_t i = 0; i < left.size();)
      {
        if (this->Convex(group[next], left[i]) == convex)
        {
          group.push_back(left[i]);
          left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        }
        else
        {
          ++i;
        }
      }
    }
    std::sort(group.begin(), group.end());
    groups.push_back(group);
  }
  return groups;
}

LocalSolid::Value LocalSolid::ValueOf(
  const Members& members, const std::vector<Value>& values, double width) const
{
  if (members.size() == 1)
  {
    return values[members.front()];
  }
  // Groups that no convex pair connects are concave to each other, and the other way round.
  for (const bool convex : { true, false })
  {
    const std::vector<Members> groups = this->Groups(members, convex);
    if (groups.size() > 1)
    {
      Value value = this->ValueOf(groups.front(), values, width);
      for (std::size_t g = 1; g < groups.size(); ++g)
      {
        value = Meeting(value, this->ValueOf(groups[g], values, width), !convex, width);
      }
      return value;
    }
  }
  // No tree describes them: leave out the last, the farthest away.
  return this->ValueOf(Members(members.begin(), members.end() - 1), values, width);
}
}
