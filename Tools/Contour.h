// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Contour.h
/// Iso-surfaces of volumes.

#ifndef arris_Contour_h
#define arris_Contour_h

#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;
class vtkPolyData;

namespace arris
{
class ProgressBar;

/// On which side of the value the solid is. Triangles face away from it.
enum class Inside
{
  Auto, ///< the side that fewer samples on the volume's six border faces are on
  Above,
  Below
};

/// The surface on which the volume has this value (vtkFlyingEdges3D). Throws a Failure if it has
/// not a single triangle. `name` is what messages call the volume.
vtkSmartPointer<vtkPolyData> Contour(vtkImageData* volume, double value, Inside inside,
  const std::string& name, ProgressBar& progress);
}

#endif
