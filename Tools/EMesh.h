// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file EMesh.h
/// Feature edges for OpenFOAM's snappyHexMesh.

#ifndef arris_EMesh_h
#define arris_EMesh_h

#include <string>

class vtkPolyData;

namespace arris
{
/// Writes polylines as a featureEdgeMesh of OpenFOAM (.eMesh): its header, the list of points, the
/// list of edges between two points each. Points in one place are written once. Throws a Failure if
/// it cannot, and then leaves what is there.
void WriteEMesh(vtkPolyData* curves, const std::string& path);
}

#endif
