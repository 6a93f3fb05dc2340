// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Surface.h
/// From VTK's polygonal data to the plain arrays of the method, and what may be wrong with it.

#ifndef arris_Surface_h
#define arris_Surface_h

#include "Core/Assembly/Assembly.h"
#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <vtkType.h>

#include <string>

class vtkPolyData;

namespace arris
{
/// How the patches of an assembly are told.
struct AssemblyParameters
{
  std::string PatchArray; ///< a cell array; see ReadPatchIds
  double MergeTolerance = 0.0; ///< of common vertices, in parts of the bounding box' diagonal
};

/// The triangles of a vtkPolyData as the method sees them.
struct Surface
{
  Mesh Triangulation;
  Connectivity Adjacency;
  double AverageEdgeLength = 0.0;

  /// The cell of the vtkPolyData that a triangle is. Cells that name a point twice are no
  /// triangles.
  vtkIdType CellOf(Index triangle) const
  {
    return this->Cells.empty() ? this->FirstCell + triangle : this->Cells[triangle];
  }

  /// The first of the cells, when all that can be triangles are.
  vtkIdType FirstCell = 0;

  /// The cell of each triangle otherwise.
  std::vector<vtkIdType> Cells;

  /// For each point the lowest of those that it is one with; empty if each is by itself. Triangles
  /// name the lowest only.
  std::vector<Index> SameAs;

  AssemblyParameters AssembledBy;
  AssemblyFacts Facts;
};

/// Makes `output` what a filter hands on before it adds anything: the input, with strips and
/// polygons cut into triangles (by vtkTriangleFilter; each takes on the cell data of what it was
/// cut from) and vertices and lines as they are. Then fills `surface` from it.
///
/// Returns what is wrong with the input, in words for a user, or nothing. Wrong is: a point that is
/// not finite or beyond 1e50 (in single precision, 1e36), a mesh of edges below 1e-50, a cell that
/// names a point that is not there, a polygon that cannot be cut into triangles, more cells than
/// 32-bit indices can count.
ARRISFILTERS_EXPORT std::string ReadSurface(
  vtkPolyData* input, vtkPolyData* output, Surface& surface);

/// The first part of ReadSurface, up to the connectivity. What is wrong with the input, or nothing;
/// then the output is empty.
std::string ReadTriangles(vtkPolyData* input, vtkPolyData* output, Surface& surface);

/// Replaces the output's points by moved ones, in the precision it has. Points whose new position
/// equals the old one keep every bit. Normals that came with the input do not fit the moved surface
/// any more: the arrays stay, but are no longer the ones to shade by.
void ReplacePoints(vtkPolyData* output, const std::vector<Vec3>& after);
}

#endif
