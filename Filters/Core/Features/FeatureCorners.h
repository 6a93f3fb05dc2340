// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureCorners.h
/// Where feature curves meet, and the tips where the surface is sharp without any.

#ifndef arris_Features_FeatureCorners_h
#define arris_Features_FeatureCorners_h

#include "Core/Curves.h"
#include "FeatureEdges.h"

namespace arris
{
enum class CornerKind : unsigned char
{
  Convex, ///< all edges are convex: of a box; a tip that sticks out
  Concave, ///< all edges are concave: in a pocket; a tip that goes in
  Saddle, ///< some are, some are: where a notch ends
  None ///< only boundary or non-manifold edges
};

struct FeatureCorner
{
  Index Vertex;
  int Valence; ///< how many curves end there; 0 for a tip
  CornerKind Kind;
  bool Tip;
  std::vector<Index>
    Curves; ///< their numbers, ascending; a loop that ends there twice stands twice
};

/// The corners of a network and the tips of the mesh besides, ascending by vertex. A tip is a
/// vertex on no feature where the surface comes together like the apex of a cone whose two flanks
/// fold by more than `tipAngle` (degrees), and not just curves on as it does around. False if the
/// monitor stopped it.
ARRISFILTERS_EXPORT bool FindFeatureCorners(const Mesh& mesh, const Connectivity& connectivity,
  const Folds& folds, const CurveNetwork& network, const std::vector<FeatureEdge>& sortedFeatures,
  double tipAngle, const Monitor& monitor, std::vector<FeatureCorner>& corners);
}

#endif
