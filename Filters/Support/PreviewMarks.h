// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file PreviewMarks.h
/// The sharp region's outline and its skeleton as geometry to look at.

#ifndef arris_PreviewMarks_h
#define arris_PreviewMarks_h

#include "Core/RegionOutline.h"
#include "Core/Skeleton.h"

class vtkPolyData;

namespace arris
{
/// Fills `marks` with the outline as lines, the skeleton's edges as tubes of that radius and its
/// vertices as balls: larger ones at joints and ends. The cell array SkeletonRole tells them apart:
/// 0 the outline, 1 tubes and branch vertices, 2 joints, 3 ends. All have normals.
void FillMarks(vtkPolyData* marks, const Mesh& mesh, const std::vector<OutlineSegment>& outline,
  const Skeleton& skeleton, double tubeRadius);
}

#endif
