// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCorners.h"

#include "Tips.h"

#include <algorithm>

namespace arris
{
namespace
{
CornerKind KindOf(bool anyConvex, bool anyConcave)
{
  if (anyConvex && anyConcave)
  {
    return CornerKind::Saddle;
  }
  if (anyConvex)
  {
    return CornerKind::Convex;
  }
  return anyConcave ? CornerKind::Concave : CornerKind::None;
}

/// The corners that curves end at.
std::vector<FeatureCorner> CornersOf(
  const CurveNetwork& network, const std::vector<FeatureEdge>& features)
{
  std::vector<FeatureCorner> corners;
  for (const CurveCorner& corner : network.Corners)
  {
    corners.push_back({ corner.Vertex, corner.Valence, CornerKind::None, false, {} });
  }
  std::vector<std::array<bool, 2>> found(corners.size(), { false, false }); // convex, concave
  const auto arrive = [&](Index vertex, Index before, Index curve)
  {
    const auto at = std::lower_bound(corners.begin(), corners.end(), vertex,
      [](const FeatureCorner& corner, Index key) { return corner.Vertex < key; });
    if (at == corners.end() || at->Vertex != vertex)
    {
      return; // a closed curve without corners
    }
    at->Curves.push_back(curve);
    const EdgeKind kind = FindFeature(features, vertex, before)->Kind;
    if (IsFold(kind))
    {
      found[at - corners.begin()][kind == EdgeKind::Concave ? 1 : 0] = true;
    }
  };
  for (std::size_t i = 0; i < network.Curves.size(); ++i)
  {
    const Curve& curve = network.Curves[i];
    arrive(curve.front(), curve[1], static_cast<Index>(i));
    arrive(curve.back(), curve[curve.size() - 2], static_cast<Index>(i));
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i].Kind = KindOf(found[i][0], found[i][1]);
  }
  return corners;
}
}

bool FindFeatureCorners(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds,
  const CurveNetwork& network, const std::vector<FeatureEdge>& sortedFeatures, double tipAngle,
  const Monitor& monitor, std::vector<FeatureCorner>& corners)
{
  Flags edged(mesh.Points.size(), 0);
  for (const FeatureEdge& edge : sortedFeatures)
  {
    edged[edge.A] = 1;
    edged[edge.B] = 1;
  }
  const std::vector<TipKind> tips = FindTips(mesh, connectivity, folds, edged, tipAngle, monitor);
  if (tips.size() != mesh.Points.size())
  {
    return false;
  }
  corners = CornersOf(network, sortedFeatures);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (tips[v] != TipKind::None)
    {
      const CornerKind kind = tips[v] == TipKind::Out ? CornerKind::Convex : CornerKind::Concave;
      corners.push_back({ v, 0, kind, true, {} });
    }
  }
  std::sort(corners.begin(), corners.end(),
    [](const FeatureCorner& a, const FeatureCorner& b) { return a.Vertex < b.Vertex; });
  return true;
}
}
