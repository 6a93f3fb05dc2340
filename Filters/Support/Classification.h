// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Classification.h
/// The stage that tells sharp vertices from smooth ones, and remembers what it computed.

#ifndef arris_Classification_h
#define arris_Classification_h

#include "Core/Parallel.h"
#include "Core/Picks.h"
#include "Support/Surface.h"

#include <vtkType.h>

class vtkPolyData;

namespace arris
{
/// λτ depends on the window but not on the angle, and takes most of the time: a filter keeps it
/// here from one execution to the next.
class Classification
{
public:
  /// Classifies the vertices of `surface`, which ReadSurface read from `input`, and adds the
  /// stage's arrays and field data to `output`. λτ is computed only if the mesh, the window or its
  /// search is another than last time; `ClassificationSeconds` is 0 if not. False if the monitor
  /// stopped it; nothing is added then.
  bool Update(vtkPolyData* input, const Surface& surface,
    const ClassificationParameters& parameters, const Monitor& monitor, vtkPolyData* output);

  /// λτ of each vertex.
  const std::vector<double>& Differences() const { return this->DifferenceOfVertex; }

  /// 1 for each sharp vertex.
  const Flags& Region() const { return this->SharpVertices; }

private:
  bool Knows(vtkPolyData* input, const AssemblyParameters& assembled,
    const ClassificationParameters& parameters) const;

  // What was classified. An address can be another mesh's later; its time cannot be so early then.
  vtkPolyData* Input = nullptr;
  vtkMTimeType InputTime = 0;
  AssemblyParameters Assembled;
  double WindowRadius = 0.0;
  WindowSearch Search = WindowSearch::Connected;

  std::vector<double> DifferenceOfVertex;
  Flags SharpVertices;
};
}

#endif
