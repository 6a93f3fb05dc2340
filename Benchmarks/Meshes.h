// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Meshes.h
/// The meshes that are timed, made on the spot.

#ifndef arris_benchmarks_Meshes_h
#define arris_benchmarks_Meshes_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkImageData;

namespace arris
{
namespace benchmarks
{
enum class MeshKind
{
  Contour, ///< of the distance to a part with planes, cylinders and a ball, by vtkFlyingEdges3D
  Irregular, ///< a contour of twice as many triangles, decimated
  Shuffled ///< a contour whose points and triangles are stored in random order
};

/// The volume whose contour at 0 has about so many thousand triangles, 1000 at most.
vtkSmartPointer<vtkImageData> Volume(int thousands);

/// A mesh of about so many thousand triangles; kept for whoever asks again. Above a million it is
/// several copies of the one with a million, side by side: the volume for one would not fit the
/// memory.
vtkPolyData* MeshOf(MeshKind kind, int thousands);

/// A contour with its edges recovered, for what is read off such meshes.
vtkPolyData* RecoveredContour(int thousands);
}
}

#endif
