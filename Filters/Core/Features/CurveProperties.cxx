// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CurveProperties.h"

#include <algorithm>
#include <limits>

namespace arris
{
namespace
{
/// The surfaces to the left and right of who walks along a curve: at its middle, as it may have its
/// first or last edge in common with others (see MergeNearCorners).
std::array<Index, 2> SurfacesBeside(const Curve& curve, const std::vector<FeatureEdge>& features,
  const std::vector<Index>& surfaceIds)
{
  const std::size_t middle = (curve.size() - 2) / 2;
  const Index a = curve[middle];
  const FeatureEdge& edge = *FindFeature(features, a, curve[middle + 1]);
  const Index left = edge.Left == NoIndex ? NoIndex : surfaceIds[edge.Left];
  const Index right = edge.Right == NoIndex ? NoIndex : surfaceIds[edge.Right];
  return a == edge.A ? std::array{ left, right } : std::array{ right, left };
}

/// Whether a curve runs the way that OrientCurves promises.
bool RunsWell(const Curve& curve, const std::vector<FeatureEdge>& features,
  const std::vector<Index>& surfaceIds)
{
  const auto [left, right] = SurfacesBeside(curve, features, surfaceIds);
  if (left == right)
  {
    return IsClosed(curve) || curve.front() < curve.back();
  }
  return right == NoIndex || (left != NoIndex && left < right);
}

/// Calls visit(edge before, edge after) for each vertex of a curve but the last of a closed one;
/// either is the other one where there is none.
template <typename Visit>
void VisitVertices(const Curve& curve, Visit&& visit)
{
  const std::size_t edges = curve.size() - 1;
  const bool closed = IsClosed(curve);
  for (std::size_t i = 0; i < (closed ? edges : curve.size()); ++i)
  {
    const std::size_t after = i == edges ? i - 1 : i;
    const std::size_t before = i > 0 ? i - 1 : (closed ? edges - 1 : 0);
    visit(before, after);
  }
}
}

void OrientCurves(const std::vector<FeatureEdge>& sortedFeatures,
  const std::vector<Index>& surfaceIds, std::vector<Curve>& curves)
{
  for (Curve& curve : curves)
  {
    if (!RunsWell(curve, sortedFeatures, surfaceIds))
    {
      std::reverse(curve.begin(), curve.end());
    }
  }
}

CurveProperties DescribeCurve(const Curve& curve, const std::vector<FeatureEdge>& sortedFeatures,
  const std::vector<Index>& surfaceIds, const std::vector<Vec3>& points)
{
  const FeatureEdge& first = *FindFeature(sortedFeatures, curve[0], curve[1]);
  const auto [left, right] = SurfacesBeside(curve, sortedFeatures, surfaceIds);
  CurveProperties properties{ 0.0, 0.0, first.DihedralAngle, first.DihedralAngle, first.Kind,
    IsClosed(curve), left, right };
  double signedSum = 0.0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
  {
    const FeatureEdge& edge = *FindFeature(sortedFeatures, curve[i], curve[i + 1]);
    const double length = (points[curve[i + 1]] - points[curve[i]]).norm();
    properties.Length += length;
    properties.MeanAngle += length * edge.DihedralAngle;
    signedSum += length * (edge.Kind == EdgeKind::Concave ? -1.0 : 1.0) * edge.DihedralAngle;
    properties.LeastAngle = std::min(properties.LeastAngle, edge.DihedralAngle);
    properties.LargestAngle = std::max(properties.LargestAngle, edge.DihedralAngle);
  }
  properties.MeanAngle = std::clamp( // whatever rounding does to it
    properties.MeanAngle / std::max(properties.Length, std::numeric_limits<double>::min()),
    properties.LeastAngle, properties.LargestAngle);
  if (IsFold(first.Kind))
  {
    properties.Kind = signedSum < 0.0 ? EdgeKind::Concave : EdgeKind::Convex;
  }
  return properties;
}

std::vector<Vec3> Tangents(const Curve& curve, const std::vector<Vec3>& points)
{
  std::vector<Vec3> tangents;
  const auto direction = [&](std::size_t edge)
  { return Vec3((points[curve[edge + 1]] - points[curve[edge]]).normalized()); };
  VisitVertices(curve,
    [&](std::size_t before, std::size_t after)
    { tangents.push_back((direction(before) + direction(after)).normalized()); });
  return tangents;
}

std::vector<double> AnglesAlong(const Curve& curve, const std::vector<FeatureEdge>& sortedFeatures)
{
  std::vector<double> angles;
  const auto angle = [&](std::size_t edge)
  { return FindFeature(sortedFeatures, curve[edge], curve[edge + 1])->DihedralAngle; };
  VisitVertices(curve,
    [&](std::size_t before, std::size_t after)
    { angles.push_back(0.5 * (angle(before) + angle(after))); });
  return angles;
}
}
