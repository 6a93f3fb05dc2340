// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Intersections.h"

#include "Flagged.h"
#include "Geometry.h"
#include "Parallel.h"
#include "SortUnique.h"
#include "TriangleCrossing.h"
#include "Vicinity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace arris
{
namespace
{
using Pair = std::array<Index, 2>;

/// The listed triangles in hashed grids of cubes, one for each level: four times as wide from one
/// level to the next, and on level 0 wide enough for most triangles. A box belongs to the level
/// whose cubes are just as wide as it, and so never fills more than eight, huge or tiny.
///
/// Of two boxes that meet, the one of the finer level finds the other on that one's level. As all
/// triangles of the mesh search but only the listed ones are in the grids, those are also in the
/// `Coarser` grids of all the levels above theirs, for larger triangles to find them there.
class Grid
{
public:
  struct Entry
  {
    Box Bounds;
    Index Triangle;
    int Level;
  };

  /// Unusable if Empty() afterwards: nothing but points was listed.
  Grid(const MeshView& mesh, const std::vector<Index>& listed)
  {
    this->CollectEntries(mesh, listed);
    if (!this->Entries.empty())
    {
      this->ChooseLevels();
      this->FillBuckets();
      this->Near = Vicinity(this->Bounds, this->Unit);
      for (const Entry& entry : this->Entries)
      {
        this->Near.Add(entry.Bounds);
      }
    }
  }
  bool Empty() const { return this->Entries.empty(); }

  /// Calls visit(t) for each listed triangle whose box meets that of the triangle `seeker`; but
  /// not for itself, nor for listed triangles that find this one when it is their turn.
  /// Rarely more than once for the same one.
  template <typename Visit>
  void Search(const MeshView& mesh, Index seeker, bool isListed, Visit&& visit) const
  {
    Box box(mesh, seeker);
    if (!this->Near.MayMeet(box))
    {
      return;
    }
    box.ClipTo(this->Bounds); // lets far larger triangles look on our levels
    const int own = this->LevelOf(box.Width());
    for (const int level : this->LevelsInUse)
    {
      if (level >= own)
      {
        this->SearchLevel(box, level, Kind::Own,
          [&](const Entry& entry)
          {
            if (!isListed || level > own || seeker < entry.Triangle)
            {
              visit(entry.Triangle);
            }
          });
      }
    }
    if (!isListed)
    {
      this->SearchLevel(
        box, own, Kind::Coarser, [&](const Entry& entry) { visit(entry.Triangle); });
    }
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  enum class Kind
  {
    Own,
    Coarser
  };

  /// Between the coarsest level and the finest; a grid is then at most 2^40 cubes wide.
  static constexpr int MostLevels = 20;
  /// Cubes of level 0 are this many times as wide as the mean box, so that most fit in.
  static constexpr double Roominess = 2.0;
  static constexpr std::size_t BucketsPerEntry = 4;
  static constexpr std::uint64_t Golden = 0x9E3779B97F4A7C15u; // 2^64 / golden ratio

  void CollectEntries(const MeshView& mesh, const std::vector<Index>& listed)
  {
    this->Entries.reserve(listed.size());
    for (const Index t : listed)
    {
      const Box box(mesh, t);
      const double width = box.Width();
      if (width > 0.0 && std::isfinite(width))
      {
        this->Entries.push_back({ box, t, 0 });
      }
    }
  }

  void ChooseLevels()
  {
    this->Bounds = this->Entries.front().Bounds;
    double sum = 0.0;
    for (const Entry& entry : this->Entries)
    {
      this->Bounds.Include(entry.Bounds);
      sum += entry.Bounds.Width();
    }
    const double mean = sum / static_cast<double>(this->Entries.size());
    this->Unit = Roominess * mean;
    this->Finest = std::numeric_limits<int>::min();
    this->Coarsest = this->LevelOf(this->Bounds.Width());
    this->Finest = this->Coarsest - MostLevels;
    for (int level = this->Finest; level <= this->Coarsest; ++level)
    {
      this->CubesPerLength.push_back(std::ldexp(1.0 / this->Unit, -2 * level));
    }
    for (Entry& entry : this->Entries)
    {
      entry.Level = this->LevelOf(entry.Bounds.Width());
      this->LevelsInUse.push_back(entry.Level);
    }
    SortUnique(this->LevelsInUse);
  }

  /// The finest level whose cubes are at least that wide.
  int LevelOf(double width) const
  {
    if (!(width > 0.0))
    {
      return this->Finest;
    }
    const int doublings = std::ilogb(width / this->Unit) + 1;
    const int level = (doublings + (doublings > 0 ? 1 : 0)) / 2; // rounds up, on either side of 0
    return std::max(level, this->Finest);
  }

  void FillBuckets()
  {
    int bits = 1;
    while ((std::size_t(1) << bits) < BucketsPerEntry * this->Entries.size())
    {
      ++bits;
    }
    this->Shift = 64 - bits;
    this->Buckets.Offsets.assign((std::size_t(1) << bits) + 1, 0);
    // Count into the place before, then add up: each offset is where its bucket ends. Filling from
    // the back moves it to where the bucket begins.
    this->ForEachPlace([&](std::size_t, std::size_t bucket) { ++this->Buckets.Offsets[bucket]; });
    Index end = 0;
    for (Index& offset : this->Buckets.Offsets)
    {
      end += offset;
      offset = end;
    }
    this->Buckets.Values.resize(end);
    this->ForEachPlace([&](std::size_t entry, std::size_t bucket)
      { this->Buckets.Values[--this->Buckets.Offsets[bucket]] = static_cast<Index>(entry); });
  }

  /// Calls place(entry, bucket) for every cube that every entry is in.
  template <typename Place>
  void ForEachPlace(Place&& place) const
  {
    for (std::size_t e = 0; e < this->Entries.size(); ++e)
    {
      const Entry& entry = this->Entries[e];
      for (int level = entry.Level; level <= this->Coarsest; ++level)
      {
        this->ForEachCube(entry.Bounds, level, level == entry.Level ? Kind::Own : Kind::Coarser,
          [&](const Cell&, std::size_t bucket) { place(e, bucket); });
      }
    }
  }

  Cell CellOf(const Vec3& point, int level) const
  {
    // Truncation rounds down, as all points are inside the bounds.
    const double perLength = this->CubesPerLength[level - this->Finest];
    const Vec3 cubes = (point - this->Bounds.Low) * perLength;
    return { static_cast<std::int64_t>(cubes[0]), static_cast<std::int64_t>(cubes[1]),
      static_cast<std::int64_t>(cubes[2]) };
  }

  template <typename Body>
  void ForEachCube(const Box& box, int level, Kind kind, Body&& body) const
  {
    const Cell low = this->CellOf(box.Low, level);
    const Cell high = this->CellOf(box.High, level);
    const std::uint64_t seed =
      2 * static_cast<std::uint64_t>(level - this->Finest) + (kind == Kind::Own ? 0 : 1);
    Cell cell;
    for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
    {
      const std::uint64_t hash0 = (seed * Golden + static_cast<std::uint64_t>(cell[0])) * Golden;
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
      {
        const std::uint64_t hash1 = (hash0 + static_cast<std::uint64_t>(cell[1])) * Golden;
        for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
        {
          const std::uint64_t hash2 = (hash1 + static_cast<std::uint64_t>(cell[2])) * Golden;
          body(cell, static_cast<std::size_t>(hash2 >> this->Shift));
        }
      }
    }
  }

  template <typename Found>
  void SearchLevel(const Box& box, int level, Kind kind, Found&& found) const
  {
    this->ForEachCube(box, level, kind,
      [&](const Cell& cell, std::size_t bucket)
      {
        for (const Index e : this->Buckets[static_cast<Index>(bucket)])
        {
          const Entry& entry = this->Entries[e];
          // Two boxes may meet in several cubes; only that with the low corner of what they have in
          // common reports them. What another cube put into the same bucket does no harm.
          if (entry.Bounds.Meets(box) &&
            this->CellOf(entry.Bounds.Low.cwiseMax(box.Low), level) == cell)
          {
            found(entry);
          }
        }
      });
  }

  std::vector<Entry> Entries;
  Box Bounds;
  Vicinity Near; ///< of the entries: most triangles of a mesh are not in it
  double Unit = 0.0;
  int Finest = 0;
  int Coarsest = 0;
  std::vector<double> CubesPerLength; ///< from the finest level on
  std::vector<int> LevelsInUse;
  Rows Buckets;
  int Shift = 0;
};

Flags Mark(const MeshView& mesh, const std::vector<Index>& triangles)
{
  Flags marks(mesh.Triangles.size(), 0);
  for (const Index t : triangles)
  {
    marks[t] = 1;
  }
  return marks;
}
}

std::vector<std::array<Index, 2>> FindIntersections(
  const MeshView& mesh, const std::vector<Index>& triangles)
{
  const Flags isListed = Mark(mesh, triangles);
  const Grid grid(mesh, Flagged(isListed));
  std::vector<Pair> pairs;
  if (grid.Empty())
  {
    return pairs;
  }
  std::mutex pairsMutex;
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      std::vector<Pair> found;
      for (Index t = begin; t < end; ++t)
      {
        grid.Search(mesh, t, isListed[t] != 0,
          [&](Index other)
          {
            const Pair pair = { std::min(t, other), std::max(t, other) };
            if (t != other && CutThrough(mesh, pair[0], pair[1]))
            {
              found.push_back(pair);
            }
          });
      }
      const std::lock_guard<std::mutex> lock(pairsMutex);
      pairs.insert(pairs.end(), found.begin(), found.end());
    });
  // The order in which the threads came is gone with this, and so are repeated finds.
  SortUnique(pairs);
  return pairs;
}
}
