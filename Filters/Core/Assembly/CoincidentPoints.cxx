// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CoincidentPoints.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace arris
{
namespace
{
/// So many cells a side can be numbered in a third of 64 bits, with one to spare on each side.
constexpr int CellBits = 20;

/// Cells are this many tolerances wide at least: then a ball of one tolerance is mostly inside one.
constexpr double CellWidth = 16.0;

/// The cubes that the listed points are in.
class Cells
{
public:
  Cells(const std::vector<Vec3>& points, const std::vector<Index>& vertices, double tolerance)
    : Low(points[vertices.front()])
  {
    Vec3 high = this->Low;
    for (Index v : vertices)
    {
      this->Low = this->Low.cwiseMin(points[v]);
      high = high.cwiseMax(points[v]);
    }
    const double extent = (high - this->Low).maxCoeff();
    this->Width = std::max(CellWidth * tolerance, std::ldexp(extent, -CellBits));
    this->Width = this->Width > 0.0 ? this->Width : 1.0; // all points are one
  }

  std::int64_t At(const Vec3& point) const
  {
    return Key(this->CellOf(point, 0), this->CellOf(point, 1), this->CellOf(point, 2));
  }

  /// Calls visit(cell) for all cells that come as near to the point as `distance`.
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
          visit(Key(x, y, z));
        }
      }
    }
  }

private:
  std::int64_t CellOf(const Vec3& point, int axis) const
  {
    return 1 + static_cast<std::int64_t>(std::floor((point[axis] - this->Low[axis]) / this->Width));
  }

  static std::int64_t Key(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    return (x << (2 * (CellBits + 1))) + (y << (CellBits + 1)) + z;
  }

  Vec3 Low;
  double Width;
};

/// The listed points sorted into cubes.
class PointGrid
{
public:
  PointGrid(const std::vector<Vec3>& points, const std::vector<Index>& vertices, double tolerance)
    : TheCells(points, vertices, tolerance)
  {
    this->Entries.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      this->Entries.push_back({ this->TheCells.At(points[vertices[i]]), static_cast<Index>(i) });
    }
    std::sort(this->Entries.begin(), this->Entries.end());
  }

  /// Calls visit(place in the list) for all points in cells that come as near as `distance`.
  template <typename Visit>
  void ForEachNear(const Vec3& point, double distance, Visit&& visit) const
  {
    this->TheCells.ForEachNear(
      point, distance, [&](std::int64_t cell) { this->ForEachIn(cell, visit); });
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

  template <typename Visit>
  void ForEachIn(std::int64_t cell, Visit& visit) const
  {
    auto entry = std::lower_bound(this->Entries.begin(), this->Entries.end(), Entry{ cell, 0 });
    for (; entry != this->Entries.end() && entry->Cell == cell; ++entry)
    {
      visit(entry->Place);
    }
  }

  Cells TheCells;
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

std::vector<Index> MayCoincideWith(const std::vector<Index>& seeds, const std::vector<Vec3>& points,
  const std::vector<Index>& vertices, double tolerance)
{
  std::vector<Index> near;
  if (seeds.empty())
  {
    return near;
  }
  const Cells cells(points, vertices, tolerance);
  std::unordered_set<std::int64_t> reached;
  const auto reachFrom = [&](Index v)
  { cells.ForEachNear(points[v], tolerance, [&](std::int64_t cell) { reached.insert(cell); }); };
  std::for_each(seeds.begin(), seeds.end(), reachFrom);
  Flags taken(vertices.size(), 0);
  for (std::size_t before = 0; before < reached.size();)
  {
    before = reached.size();
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (!taken[i] && reached.count(cells.At(points[vertices[i]])) > 0)
      {
        taken[i] = 1;
        reachFrom(vertices[i]);
      }
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (taken[i])
    {
      near.push_back(vertices[i]);
    }
  }
  return near;
}
}
