// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Settled.h"

#include "Spread.h"

namespace arris
{
namespace
{
// In local scales. Nearer than this, a vertex beside the open ones is placed again: sheets that had
// these as samples are fitted without them now. Measured: at 4 edges lose something, 8 gives
// nothing more.
constexpr double OpenReach = 6.0;

/// So far sides are fitted and labels known: what is placed asks its neighbours for theirs.
constexpr double FittedReach = 8.0;
}

Settled FindSettled(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<double>& scales, const std::vector<Index>& open)
{
  Settled settled;
  settled.Vertices.assign(mesh.Points.size(), 1);
  settled.Unfitted = settled.Vertices;
  const Walk walk =
    WalkFrom(open, FittedReach, mesh, connectivity, scales, [](Index) { return true; });
  for (Index v : walk.Reached)
  {
    settled.Unfitted[v] = 0;
    const double distance = (mesh.Points[v] - mesh.Points[walk.OriginOf[v]]).norm();
    if (distance <= OpenReach * scales[v])
    {
      settled.Vertices[v] = 0;
    }
  }
  return settled;
}
}
