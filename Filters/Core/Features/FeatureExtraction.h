// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureExtraction.h
/// From a mesh to its feature curves, corners and faces.
///
///  1. FeatureSelection: the mesh edges that are features.
///  2. Surfaces: the smooth faces between them; Slivers: those that are none.
///  3. Curves, NearCorners, CurveProperties: the edges joined, split at corners, and which way they
///  run.
///  4. FeatureCorners, Tips: where curves meet, and what is sharp without a curve.
///  5. Fits: the shapes of the faces.

#ifndef arris_Features_FeatureExtraction_h
#define arris_Features_FeatureExtraction_h

#include "Core/Fits/FaceFit.h"
#include "FeatureCorners.h"
#include "FeatureSelection.h"
#include "Surfaces.h"

namespace arris
{
struct ExtractionParameters
{
  FeatureCriteria Criteria;
  bool FitShapes;
  double FitTolerance; ///< see FitFaces
};

struct FeatureSet
{
  std::vector<FeatureEdge> Edges; ///< sorted by A, then B
  Surfaces Faces;
  CurveNetwork Network; ///< oriented
  std::vector<FeatureCorner> Corners;
  std::vector<FaceFit> Fits; ///< one a face, or none
};

/// Finds them all. False if the monitor stopped it; the set is then unfinished.
ARRISFILTERS_EXPORT bool ExtractFeatures(const Mesh& mesh, const Connectivity& connectivity,
  const ExtractionParameters& parameters, const Monitor& monitor, FeatureSet& features);
}

#endif
