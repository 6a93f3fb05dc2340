// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ObjCheck.h
/// What vtkOBJReader does not tell about a Wavefront OBJ file.

#ifndef arris_ObjCheck_h
#define arris_ObjCheck_h

#include <vtkType.h>

#include <string>

namespace arris
{
struct ObjCheck
{
  std::string Problem; ///< what is wrong with it, or nothing
  vtkIdType VertexCount = 0; ///< how many the file lists
};

/// Reads vertices and faces: vtkOBJReader takes a vertex that is not three numbers for the origin,
/// and writes where it should not if a face names none, or one that is not there.
ObjCheck CheckObj(const std::string& path);
}

#endif
