// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RegionOutline.h"

namespace arris
{
namespace
{
/// Where between two vertices on different sides the threshold is passed.
Vec3 Crossing(
  const Mesh& mesh, const std::vector<double>& values, double threshold, Index from, Index to)
{
  const double part = (threshold - values[from]) / (values[to] - values[from]);
  return mesh.Points[from] + part * (mesh.Points[to] - mesh.Points[from]);
}
}

std::vector<OutlineSegment> RegionOutline(
  const Mesh& mesh, const std::vector<double>& values, double threshold)
{
  std::vector<OutlineSegment> outline;
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    const Triangle& triangle = mesh.Triangles[t];
    bool inside[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      inside[corner] = values[triangle[corner]] >= threshold;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      // The corner that is alone on its side: the line passes between it and the two others.
      const int next = Next(corner);
      const int last = Next(next);
      if (inside[corner] != inside[next] && inside[next] == inside[last])
      {
        outline.push_back({ Crossing(mesh, values, threshold, triangle[corner], triangle[next]),
          Crossing(mesh, values, threshold, triangle[corner], triangle[last]), t });
      }
    }
  }
  return outline;
}
}
