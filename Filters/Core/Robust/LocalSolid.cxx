// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LocalSolid.h"

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

double LocalSolid::Value(const Vec3& point) const
{
  Members all;
  std::vector<double> distances;
  for (std::size_t k = 0; k < this->Sheets.size(); ++k)
  {
    all.push_back(static_cast<int>(k));
    distances.push_back(this->Sheets[k].Distance(point));
  }
  return this->ValueOf(all, distances);
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

double LocalSolid::ValueOf(const Members& members, const std::vector<double>& distances) const
{
  if (members.size() == 1)
  {
    return distances[members.front()];
  }
  // Groups that no convex pair connects are concave to each other, and the other way round.
  for (const bool convex : { true, false })
  {
    const std::vector<Members> groups = this->Groups(members, convex);
    if (groups.size() > 1)
    {
      double value = this->ValueOf(groups.front(), distances);
      for (std::size_t g = 1; g < groups.size(); ++g)
      {
        const double other = this->ValueOf(groups[g], distances);
        value = convex ? std::min(value, other) : std::max(value, other);
      }
      return value;
    }
  }
  // No tree describes them: leave out the last, the farthest away.
  return this->ValueOf(Members(members.begin(), members.end() - 1), distances);
}
}
