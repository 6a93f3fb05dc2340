// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Vicinity.h
/// Tells at once of most boxes that they meet none of some others.

#ifndef arris_Vicinity_h
#define arris_Vicinity_h

#include "Box.h"

#include <algorithm>

namespace arris
{
/// The cubes that boxes are in, of few enough that all of them stay in the cache.
class Vicinity
{
public:
  Vicinity() = default;

  /// For boxes inside `bounds`, most of them no wider than `width`.
  Vicinity(const Box& bounds, double width)
    : Bounds(bounds)
    , CubeWidth(std::max(width, bounds.Width() / (PerSide - 1)))
    , CubesPerLength(1.0 / CubeWidth)
    , Near(std::size_t(PerSide) * PerSide * PerSide, 0)
  {
  }

  /// Marks the cubes of a box, and those before them: narrow boxes that begin there may reach it.
  void Add(const Box& box)
  {
    const Cube low = this->CubeOf(box.Low);
    const Cube high = this->CubeOf(box.High);
    Cube cube;
    for (cube[0] = std::max(0, low[0] - 1); cube[0] <= high[0]; ++cube[0])
    {
      for (cube[1] = std::max(0, low[1] - 1); cube[1] <= high[1]; ++cube[1])
      {
        for (cube[2] = std::max(0, low[2] - 1); cube[2] <= high[2]; ++cube[2])
        {
          this->Near[Place(cube)] = 1;
        }
      }
    }
  }

  /// False only if none of the added boxes meets this one.
  bool MayMeet(const Box& box) const
  {
    return box.Meets(this->Bounds) &&
      (box.Width() > this->CubeWidth || this->Near[Place(this->CubeOf(box.Low))] != 0);
  }

private:
  using Cube = std::array<int, 3>;
  static constexpr int PerSide = 64;

  Cube CubeOf(const Vec3& point) const
  {
    Cube cube;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double place = (point[axis] - this->Bounds.Low[axis]) * this->CubesPerLength;
      cube[axis] = place > 0.0 ? static_cast<int>(std::min(place, PerSide - 1.0)) : 0;
    }
    return cube;
  }

  static std::size_t Place(const Cube& cube)
  {
    return (std::size_t(cube[0]) * PerSide + cube[1]) * PerSide + cube[2];
  }

  Box Bounds;
  double CubeWidth = 0.0;
  double CubesPerLength = 0.0;
  Flags Near;
};
}

#endif
