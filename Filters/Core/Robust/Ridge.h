// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Ridge.h
/// Where labels meet: which vertices become the skeleton, and which face each triangle is part of.

#ifndef arris_Robust_Ridge_h
#define arris_Robust_Ridge_h

#include "Labels.h"

namespace arris
{
/// All that has been found out about the damaged vertices.
struct Labelling
{
  std::vector<Index> Labels; ///< for each vertex its patch
  std::vector<std::vector<Side>> Sides; ///< of the vertices of the region, in their order
  std::vector<Index> SidesOf; ///< for each vertex where in Sides; NoIndex if intact

  /// The sheet of a label as a vertex sees it, or one of its neighbours does; null if none.
  const Sheet* SheetAt(const Connectivity& connectivity, Index vertex, Index label) const;
};

struct Ridge
{
  Flags OnRidge; ///< 1 for the skeleton's vertices
  std::vector<Index> FaceLabels; ///< for each triangle its label, NoIndex away from the region
};

Ridge FindRidge(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const Labelling& labelling);

/// Normals closer than this are one face for the purpose of edges, in degrees.
constexpr double LeastCrossingAngle = 15.0;
}

#endif
