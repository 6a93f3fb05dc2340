// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureEdges.h
/// The mesh edges that are features, and which of all edges they are chosen from.

#ifndef arris_Features_FeatureEdges_h
#define arris_Features_FeatureEdges_h

#include "Folds.h"

namespace arris
{
/// A mesh edge between its two vertices, the lower first.
struct FeatureEdge
{
  Index A;
  Index B;
  double DihedralAngle; ///< between the normals of its triangles, degrees: 0 flat, 180 folded back;
                        ///< 0 on the boundary, the largest of two at a non-manifold edge
  EdgeKind Kind;

  /// The triangles to the left and to the right of who walks from A to B on the outside, or
  /// NoIndex. At a non-manifold edge and between triangles wound against each other: any two.
  Index Left;
  Index Right;
};

/// Edge k of triangle t.
ARRISFILTERS_EXPORT FeatureEdge MakeFeature(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index t, int k);

/// The edge between two vertices that share a triangle.
ARRISFILTERS_EXPORT FeatureEdge MakeFeatureBetween(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, Index a, Index b);

/// The edges with two triangles that fold by more than `least` degrees, and all on the boundary and
/// with three triangles and more; sorted by A, then B.
ARRISFILTERS_EXPORT std::vector<FeatureEdge> CandidateEdges(
  const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, double least);

/// The order of edges: by A, then B.
inline bool ComesBefore(const FeatureEdge& one, const FeatureEdge& other)
{
  return one.A != other.A ? one.A < other.A : one.B < other.B;
}

/// Sorts edges so.
ARRISFILTERS_EXPORT void SortEdges(std::vector<FeatureEdge>& edges);

/// Where the edge between two vertices stands among edges sorted as above, or null.
ARRISFILTERS_EXPORT const FeatureEdge* FindFeature(
  const std::vector<FeatureEdge>& sortedFeatures, Index a, Index b);

/// Their two ends alone.
ARRISFILTERS_EXPORT std::vector<std::array<Index, 2>> EndsOf(const std::vector<FeatureEdge>& edges);

/// Whether two triangles meet there, so that the edge has an angle.
inline bool IsFold(EdgeKind kind)
{
  return kind == EdgeKind::Convex || kind == EdgeKind::Concave;
}
}

#endif
