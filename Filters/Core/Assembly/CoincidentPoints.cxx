// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CoincidentPoints.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
/// So many cells a side can be numbered in a third of 64 bits, with one to spare on each side.
constexpr int CellBits = 20;

/// Cells are this many tolerances wide at least: then a ball of one tolerance is mostly inside one.
constexpr double CellWidth = 16.0;

/// The listed points sorted into cubes.
class PointGrid
{
public:
  PointGrid(const std::vector<Vec3>& points, const std::vector<Index>& vertices, double tolerance)
  {
    Vec3 high = points[vertices.front()];
    this->Low = high;
    for (Index v : vertices)
    {
      this->Low = this->Low.cwiseMin(points[v]);
      high = high.cwiseMax(points[v]);
    }
    const double extent = (high - this->Low).maxCoeff();
    this->Width = std::max(CellWidth * tolerance, std::ldexp(extent, -CellBits));
    this->Width = this->Width > 0.0 ? this->Width : 1.0; // all points are one
    this->Entries.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const Vec3& p = points[vertices[i]];
      this->Entries.push_back(
        { Key(this->CellOf(p, 0), this->CellOf(p, 1), this->CellOf(p, 2)), static_cast<Index>(i) });
    }
    std::sort(this->Entries.begin(), this->Entries.end());
  }

  /// Calls visit(place in the list) for all points in cells that come as near as `distance`.
  template <typename Visit>
  void ForEachNear(const Vec3& point, double distance, Visit&& visit) const
  {
    const Vec3 reach = Vec3::Constant(distance);
    const Vec3 from = point - reach;
    const Vec3 to = point + reach;
    for (std::int64_t x = this->CellOf(from, 0); x <= this->CellOf(to, 0); ++x)
    {
      for (std::int64_t y = this->CellOf(from, 1); y <= this->CellOf(to, 1); ++y)
      {
        for (std::int64_t z = this->CellOf(from, 2); z <= this->CellOf(to, 2); ++z)
        {
          this->ForEachIn(Key(x, y, z), visit);
        }
      }
    }
  }

private:
  struct Entry
  {
    std::int64_t Cell;
    Index Place;
    bool operator<(const Entry& other) const
    {
      return this->Cell != other.Cell ? this->Cell < other.Cell : this->Place < other.Place;
    }
  };

  std::int64_t CellOf(const Vec3& point, int axis) const
  {
    return 1 + static_cast<std::int64_t>(std::floor((point[axis] - this->Low[axis]) / this->Width));
  }

  static std::int64_t Key(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    return (x << (2 * (CellBits + 1))) + (y << (CellBits + 1)) + z;
  }

  template <typename Visit>
  void ForEachIn(std::int64_t cell, Visit& visit) const
  {
    auto entry = std::lower_bound(this->Entries.begin(), this->Entries.end(), Entry{ cell, 0 });
    for (; entry != this->Entries.end() && entry->Cell == cell; ++entry)
    {
      visit(entry->Place);
    }
  }

  Vec3 Low;
  double Width;
  std::vector<Entry> Entries;
};
}

std::vector<Index> LowestCoincident(
  const std::vector<Vec3>& points, const std::vector<Index>& vertices, double tolerance)
{
  std::vector<Index> lowest(vertices.size(), NoIndex);
  if (vertices.empty())
  {
    return lowest;
  }
  const PointGrid grid(points, vertices, tolerance);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (lowest[i] != NoIndex)
    {
      continue;
    }
    const Vec3& point = points[vertices[i]];
    grid.ForEachNear(point, tolerance,
      [&](Index place)
      {
        if (lowest[place] == NoIndex && (points[vertices[place]] - point).norm() <= tolerance)
        {
          lowest[place] = vertices[i];
        }
      });
  }
  return lowest;
}
}
