// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureOutputs.h
/// Feature curves, corners and faces as VTK's data.

#ifndef arris_FeatureOutputs_h
#define arris_FeatureOutputs_h

#include "Core/Features/FeatureExtraction.h"

class vtkPolyData;
class vtkTable;

namespace arris
{
/// Fills `lines` with one polyline a curve, each on points of its own with the arrays of the mesh's
/// points there, and the arrays of output 0 of vtkSharpEdgeExtractor. A `resampleStep` above 0 puts
/// the points at that distance, with arrays interpolated.
void FillCurves(vtkPolyData* lines, const FeatureSet& features, const std::vector<Vec3>& points,
  double resampleStep, vtkPolyData* mesh);

/// Fills `vertices` with one vertex a corner, with its point's arrays and those of output 1.
void FillCorners(
  vtkPolyData* vertices, const std::vector<FeatureCorner>& corners, vtkPolyData* mesh);

/// Fills the table of output 3: one row a surface. Without fits (there are none, or one a surface)
/// it has no columns of shapes.
void FillFaceTable(
  vtkTable* table, const std::vector<SurfaceMeasures>& measures, const std::vector<FaceFit>& fits);
}

#endif
