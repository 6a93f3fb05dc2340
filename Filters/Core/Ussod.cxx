// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Ussod.h"

#include "ConnectedWindow.h"
#include "Geometry.h"
#include "NormalSpread.h"
#include "SpatialWindow.h"

namespace arris
{
namespace
{
/// `makeWindow()` gives each stretch of vertices a window of its own.
template <typename MakeWindow>
std::vector<double> DifferencesBy(MakeWindow&& makeWindow, const Mesh& mesh,
  const std::vector<Vec3>& unitNormals, double radius, const Monitor& monitor)
{
  std::vector<double> differences(mesh.Points.size());
  const bool finished = ParallelFor(mesh.VertexCount(), monitor,
    [&](Index begin, Index end)
    {
      auto window = makeWindow();
      NormalSpread spread;
      for (Index v = begin; v < end; ++v)
      {
        differences[v] = spread.Largest(window.Gather(v, radius), unitNormals);
      }
    });
  return finished ? differences : std::vector<double>();
}
}

std::vector<double> NormalDifferences(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Vec3>& unitNormals, double windowRadius, WindowSearch search,
  const Monitor& monitor)
{
  if (search == WindowSearch::Connected)
  {
    return DifferencesBy([&] { return ConnectedWindow(mesh, connectivity); }, mesh, unitNormals,
      windowRadius, monitor);
  }
  const WindowGrid grid(mesh, windowRadius);
  return DifferencesBy([&] { return SpatialWindow(mesh, connectivity, grid); }, mesh, unitNormals,
    windowRadius, monitor);
}

Flags SharpRegion(const std::vector<double>& normalDifferences, double sharpAngle)
{
  const double threshold = DifferenceOfAngle(sharpAngle);
  Flags sharp(normalDifferences.size());
  for (std::size_t v = 0; v < sharp.size(); ++v)
  {
    sharp[v] = normalDifferences[v] >= threshold ? 1 : 0;
  }
  return sharp;
}
}
