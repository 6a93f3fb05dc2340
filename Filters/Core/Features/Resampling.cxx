// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Resampling.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace arris
{
namespace
{
/// Into how many pieces a curve is cut: a whole number, or infinity.
double PiecesOf(const Curve& curve, double length, double step)
{
  return std::max(IsClosed(curve) ? 3.0 : 1.0, std::round(length / step));
}
}

std::vector<CurvePoint> VerticesOf(const Curve& curve)
{
  std::vector<CurvePoint> vertices;
  for (std::size_t i = 0; i + (IsClosed(curve) ? 1 : 0) < curve.size(); ++i)
  {
    vertices.push_back({ i, 0.0 });
  }
  return vertices;
}

std::vector<CurvePoint> Resampled(const Curve& curve, const std::vector<Vec3>& points, double step)
{
  // Along the polyline itself: a spline would be rounder, but leave the mesh.
  const double length = LengthOf(curve, points);
  const bool closed = IsClosed(curve);
  const auto steps = static_cast<std::size_t>(PiecesOf(curve, length, step));
  std::vector<CurvePoint> samples;
  std::size_t edge = 0;
  double before = 0.0; // the length up to the edge
  for (std::size_t i = 0; i < steps; ++i)
  {
    const double at = length * static_cast<double>(i) / static_cast<double>(steps);
    double edgeLength = (points[curve[edge + 1]] - points[curve[edge]]).norm();
    while (edge + 2 < curve.size() && before + edgeLength < at)
    {
      before += edgeLength;
      ++edge;
      edgeLength = (points[curve[edge + 1]] - points[curve[edge]]).norm();
    }
    const double share = edgeLength > 0.0 ? std::clamp((at - before) / edgeLength, 0.0, 1.0) : 0.0;
    samples.push_back({ edge, share });
  }
  if (!closed)
  {
    samples.push_back({ curve.size() - 1, 0.0 });
  }
  return samples;
}

std::string ProblemWithStep(
  const std::vector<Curve>& curves, const std::vector<Vec3>& points, double step)
{
  double most = MostPointsAdded;
  double wanted = 0.0;
  for (const Curve& curve : curves)
  {
    most += static_cast<double>(curve.size());
    wanted += PiecesOf(curve, LengthOf(curve, points), step);
  }
  if (wanted <= most)
  {
    return {};
  }
  std::ostringstream words;
  words << "ResampleStep is too small: " << step << " would put " << wanted
        << " points on the curves, and " << most << " is the most";
  return words.str();
}
}
