// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeLengths.h"

#include "ExactSum.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace arris
{
namespace
{
/// Visits the squares of the lengths.
template <typename Visit>
void ForEachSquareFrom(
  Index vertex, const Mesh& mesh, const Connectivity& connectivity, Visit&& visit)
{
  for (Index neighbor : connectivity.NeighborsOfVertex[vertex])
  {
    if (vertex < neighbor) // or it is counted at both ends
    {
      visit((mesh.Points[neighbor] - mesh.Points[vertex]).squaredNorm());
    }
  }
}

double LongestEdge(const Mesh& mesh, const Connectivity& connectivity)
{
  double longest = 0.0;
  std::mutex mutex;
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      double own = 0.0;
      for (Index v = begin; v < end; ++v)
      {
        ForEachSquareFrom(
          v, mesh, connectivity, [&](double square) { own = std::max(own, square); });
      }
      const std::lock_guard<std::mutex> lock(mutex);
      longest = std::max(longest, own);
    });
  return std::sqrt(longest);
}

/// The mean of a function, from -1 to 1, of the edges' lengths that are `least` at least; 0 if
/// there is none.
template <typename Function>
double MeanOverEdges(
  const Mesh& mesh, const Connectivity& connectivity, double least, Function&& function)
{
  const auto [sum, count] = ExactSums<2>(mesh.VertexCount(),
    [&](Index v, auto& sums)
    {
      ForEachSquareFrom(v, mesh, connectivity,
        [&](double square)
        {
          const double length = std::sqrt(square);
          if (length >= least)
          {
            sums[0].Add(function(length));
            sums[1].Add(1.0);
          }
        });
    });
  return count.Value() > 0.0 ? sum.Value() / count.Value() : 0.0;
}
}

double AverageEdgeLength(const Mesh& mesh, const Connectivity& connectivity)
{
  const double longest = LongestEdge(mesh, connectivity);
  return longest > 0.0 ? longest *
      MeanOverEdges(mesh, connectivity, 0.0, [&](double length) { return length / longest; })
                       : 0.0;
}

double GeometricMeanEdgeLength(const Mesh& mesh, const Connectivity& connectivity)
{
  constexpr double Octaves = 200.0; // more than lie between the longest and shortest edges allowed
  const double longest = LongestEdge(mesh, connectivity);
  const double shortest = longest * std::exp2(-Octaves);
  return shortest > 0.0 ? longest *
      std::exp2(Octaves *
        MeanOverEdges(mesh, connectivity, shortest,
          [&](double length) { return std::log2(length / longest) / Octaves; }))
                        : 0.0;
}
}
