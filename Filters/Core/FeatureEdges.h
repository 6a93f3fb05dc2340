// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureEdges.h
/// The mesh edges where the surface folds: n1.n2 < 1 - κλ, end of section 5.

#ifndef arris_FeatureEdges_h
#define arris_FeatureEdges_h

#include "Mesh.h"
#include "Parallel.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// A mesh edge between its two vertices, the lower first.
struct FeatureEdge
{
  Index A;
  Index B;
  double DihedralAngle; ///< between the normals of its triangles, degrees: 0 flat, 180 folded back
};

/// The edges whose triangles' normals differ by more than `featureAngle` (degrees), and those where
/// three or more triangles meet (with the largest angle between two of them), sorted by A, then B.
/// A triangle wound against its neighbour is read the other way round. Triangles without area have
/// no normal and make no feature. Empty if the monitor stopped it.
ARRISFILTERS_EXPORT std::vector<FeatureEdge> FindFeatureEdges(
  const Mesh& mesh, const Connectivity& connectivity, double featureAngle, const Monitor& monitor);

/// The feature between two vertices among features sorted as above, or null.
ARRISFILTERS_EXPORT const FeatureEdge* FindFeature(
  const std::vector<FeatureEdge>& sortedFeatures, Index a, Index b);
}

#endif
