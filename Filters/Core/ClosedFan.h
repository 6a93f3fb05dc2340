// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ClosedFan.h
/// The triangles around a vertex as nearly all are: few, wound alike, and two at each edge.

#ifndef arris_ClosedFan_h
#define arris_ClosedFan_h

#include "Mesh.h"

#include <array>

namespace arris
{
/// Pairs the triangles around a vertex by the edges there, without a branch that depends on the
/// order of neighbours, which nothing foresees, and without sorting.
class ClosedFan
{
public:
  /// More than nearly all vertices have; loops over so many at once need no more registers than
  /// there are.
  static constexpr Index Most = 8;

  /// Looks at the triangles around a vertex; false if they are no closed fan of `Most` at most.
  bool Gather(const Mesh& mesh, IndexSpan triangles, Index vertex)
  {
    this->Size = triangles.size();
    if (this->Size > Most)
    {
      return false;
    }
    this->Leaving.fill(NoIndex);
    for (Index i = 0; i < this->Size; ++i)
    {
      const Triangle& triangle = mesh.Triangles[triangles[i]];
      this->Corner[i] = CornerOf(triangle, vertex);
      this->Leaving[i] = triangle[Next(this->Corner[i])];
      this->Arriving[i] = triangle[Next(Next(this->Corner[i]))];
    }
    return this->Pair();
  }

  /// Calls visit(i, j, neighbor, rank) for each edge: triangle i of those around leaves the vertex
  /// by it, j arrives; so many neighbours are lower.
  template <typename Visit>
  void ForEachEdge(Visit&& visit) const
  {
    for (Index i = 0; i < this->Size; ++i)
    {
      visit(i, this->Partner[i], this->Leaving[i], this->Lower[i]);
    }
  }

  /// Which of their edges triangle i leaves and arrives by.
  int LeavingEdge(Index i) const { return this->Corner[i]; }
  int ArrivingEdge(Index i) const { return Next(Next(this->Corner[i])); }

private:
  /// Finds for each triangle the one that arrives by the edge it leaves by. False unless there is
  /// one for each, and each for one.
  bool Pair()
  {
    // Of all triangles at a time, in local arrays: so that the compiler takes them in registers.
    const std::array<Index, Most> from = this->Leaving;
    std::array<Index, Most> found{};
    std::array<Index, Most> partner{};
    std::array<Index, Most> lower{};
    for (Index j = 0; j < this->Size; ++j)
    {
      const Index arriving = this->Arriving[j];
      const Index leaving = this->Leaving[j];
      for (Index i = 0; i < Most; ++i)
      {
        const Index same = -static_cast<Index>(from[i] == arriving); // all bits or none
        found[i] -= same;
        partner[i] += same & j;
        lower[i] += static_cast<Index>(leaving < from[i]);
      }
    }
    this->Partner = partner;
    this->Lower = lower;
    unsigned partners = 0;
    bool once = true;
    for (Index i = 0; i < this->Size; ++i)
    {
      once = once && found[i] == 1;
      partners |= 1U << static_cast<unsigned>(partner[i]);
    }
    return once && partners == (1U << static_cast<unsigned>(this->Size)) - 1;
  }

  Index Size = 0;
  std::array<int, Most> Corner;
  std::array<Index, Most> Leaving, Arriving; // the neighbours
  std::array<Index, Most> Partner, Lower;
};
}

#endif
