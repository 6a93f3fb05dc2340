// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PickedPoints.h
/// From selections and positions to picked vertices, with the names that messages call them by.

#ifndef arris_PickedPoints_h
#define arris_PickedPoints_h

#include "Core/Picks.h"
#include "Support/Surface.h"

#include <string>
#include <vector>

class vtkPoints;
class vtkPolyData;
class vtkSelection;

namespace arris
{
/// How far from the mesh a picked position may be, in average edge lengths: a lost edge lies within
/// an edge or two of the surface that is left.
constexpr double LargestPickDistance = 5.0;

struct PickedPoints
{
  std::vector<Pick> Vertices;
  std::vector<std::string> Names; ///< "point 17", "cell 3", "(1, 2, 3)"
};

/// Adds what a selection selects of the input's points or cells, see EvaluateSelection; a null one
/// nothing. What is wrong with it, or nothing.
std::string AddSelection(vtkSelection* selection, vtkPolyData* input, PickedPoints& picked);

/// Adds the vertex nearest to each position, of those that triangles have; of equally near ones the
/// first. What is wrong with the positions, or nothing.
std::string AddPositions(vtkPoints* positions, const Surface& surface, PickedPoints& picked);

/// The parameters that picked points ask for, see FollowPicks; what is wrong with the picks, or
/// nothing.
std::string FollowPickedPoints(const Surface& surface, const PickedPoints& sharp,
  const PickedPoints& smooth, ClassificationParameters& parameters);
}

#endif
