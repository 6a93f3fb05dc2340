// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureSelection.h"

#include "Gaps.h"
#include "Noise.h"
#include "Tails.h"

namespace arris
{
bool SelectFeatures(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds,
  const FeatureCriteria& criteria, const Monitor& monitor, std::vector<FeatureEdge>& edges)
{
  const std::vector<FeatureEdge> candidates =
    CandidateEdges(mesh, connectivity, folds, criteria.Band.Continuation);
  const std::vector<double> angles =
    QuietAngles(mesh, connectivity, folds, candidates, criteria.NoiseFactor, monitor);
  if (angles.size() != candidates.size())
  {
    return false;
  }
  edges = ChooseEdges(candidates, angles, mesh.Points, criteria.Band, criteria.Boundary,
    criteria.NonManifold, criteria.Likely);
  CloseGaps(mesh, connectivity, folds, criteria.GapLength, edges);
  CutTails(mesh.Points, connectivity.OnBoundary, criteria, edges);
  CloseFoldedGaps(
    mesh, connectivity, folds, criteria.FoldedGapLength, criteria.Band.Continuation, edges);
  return true;
}
}
