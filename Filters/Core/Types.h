// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Types.h
/// The words the method is written in: indices, points, triangles and spans of them.

#ifndef arris_Types_h
#define arris_Types_h

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace arris
{
/// Counts vertices, triangles and corners of triangles. 32 bits halve the memory that the
/// adjacency needs, and still hold a mesh of 700 million triangles.
using Index = std::int32_t;

/// Stands where an index could be and none is.
constexpr Index NoIndex = -1;

using Vec3 = Eigen::Vector3d;
using Triangle = std::array<Index, 3>;

/// A yes or no a vertex; not std::vector<bool>, whose neighbours cannot be written by two threads.
using Flags = std::vector<unsigned char>;

/// A read-only stretch of an array (what std::span is from C++20 on).
class IndexSpan
{
public:
  IndexSpan(const Index* first, const Index* last)
    : First(first)
    , Last(last)
  {
  }
  const Index* begin() const { return this->First; }
  const Index* end() const { return this->Last; }
  Index size() const { return static_cast<Index>(this->Last - this->First); }
  bool empty() const { return this->First == this->Last; }
  Index operator[](Index i) const { return this->First[i]; }

private:
  const Index* First;
  const Index* Last;
};
}

#endif
