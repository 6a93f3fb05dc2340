// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file MeshFiles.h
/// Reads and writes meshes, in the format that the extension of the name tells.

#ifndef arris_MeshFiles_h
#define arris_MeshFiles_h

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

namespace arris
{
class ProgressBar;

/// What a file is to hold. Not every format can.
enum class Content
{
  Mesh, ///< .vtp .vtk .ply .stl .obj
  MeshWithArrays, ///< .vtp .vtk
  Curves ///< .vtp .vtk .obj
};

/// Reads a mesh from .vtp .vtk .ply .stl .obj, with the arrays it has. Points that a format cannot
/// share between triangles (.stl), or that the reader took apart (.obj with normals or texture
/// coordinates of their own), are merged where they coincide exactly. Throws a Failure if there is
/// no mesh with triangles to be had.
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& path, ProgressBar& progress);

/// Reads polylines from .vtp .vtk .obj; throws a Failure if there are none.
vtkSmartPointer<vtkPolyData> ReadCurves(const std::string& path, ProgressBar& progress);

/// Throws a Failure if such content cannot be written there.
void CheckMeshOutput(const std::string& path, Content content);

/// Writes it, or throws a Failure and leaves what is there.
void WriteMesh(vtkPolyData* mesh, const std::string& path, ProgressBar& progress);
}

#endif
