// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureExtraction.h"

#include "CurveProperties.h"
#include "NearCorners.h"
#include "Slivers.h"
#include "Tails.h"
#include "Tips.h"

#include <algorithm>
#include <iterator>

namespace arris
{
namespace
{
/// Curves are not split where folds change from convex to concave, as those that fade do.
std::vector<int> SortsOf(const std::vector<FeatureEdge>& edges)
{
  std::vector<int> sorts;
  sorts.reserve(edges.size());
  for (const FeatureEdge& edge : edges)
  {
    sorts.push_back(IsFold(edge.Kind) ? -1 : static_cast<int>(edge.Kind));
  }
  return sorts;
}

/// Those of some edges that are not among the others; both are sorted.
std::vector<FeatureEdge> Missing(
  const std::vector<FeatureEdge>& before, const std::vector<FeatureEdge>& after)
{
  std::vector<FeatureEdge> missing;
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
    std::back_inserter(missing), ComesBefore);
  return missing;
}
}

bool ExtractFeatures(const Mesh& mesh, const Connectivity& connectivity,
  const ExtractionParameters& parameters, const Monitor& monitor, FeatureSet& features)
{
  // How far the progress has come after each step, by its usual share of the time.
  constexpr double Folded = 0.4;
  constexpr double Selected = 0.6;
  constexpr double Cornered = 0.8;

  const AngleBand& band = parameters.Criteria.Band;
  const double least =
    std::min(DifferenceOfAngle(band.Continuation), LeastFoldAtTips(band.Seed)); // that anyone asks
  const Folds folds = FindFolds(mesh, connectivity, monitor.Part(0.0, Folded), least);
  if (folds.Normals.size() != mesh.Triangles.size() ||
    !SelectFeatures(mesh, connectivity, folds, parameters.Criteria, monitor.Part(Folded, Selected),
      features.Edges))
  {
    return false;
  }
  features.Faces = FindSurfaces(mesh, connectivity, features.Edges);
  std::vector<FeatureEdge> before = features.Edges;
  while (DropSlivers(mesh, features.Faces, features.Edges)) // each time there are fewer edges
  {
    CutTails(mesh.Points, connectivity.OnBoundary, parameters.Criteria, features.Edges);
    JoinSurfaces(mesh, connectivity, Missing(before, features.Edges), features.Faces);
    before = features.Edges;
  }
  CountLoops(mesh, connectivity, features.Edges, features.Faces);
  features.Network = JoinEdges(EndsOf(features.Edges), mesh.Points,
    { band.Turn, parameters.Criteria.CornerReach, SortsOf(features.Edges), true });
  MergeNearCorners(mesh.Points, features.Network);
  OrientCurves(features.Edges, features.Faces.Ids, features.Network.Curves);
  if (!FindFeatureCorners(mesh, connectivity, folds, features.Network, features.Edges, band.Seed,
        monitor.Part(Selected, Cornered), features.Corners))
  {
    return false;
  }
  if (!parameters.FitShapes)
  {
    return monitor.Report(1.0);
  }
  const std::size_t faces = features.Faces.Measures.size();
  features.Fits = FitFaces(mesh, features.Faces.Ids, static_cast<Index>(faces),
    parameters.FitTolerance, monitor.Part(Cornered, 1.0));
  return features.Fits.size() == faces;
}
}
