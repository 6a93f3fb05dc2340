// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Surface.h
/// From VTK's polygonal data to the plain arrays of the method, and what may be wrong with it.

#ifndef arris_Surface_h
#define arris_Surface_h

#include "Core/Assembly/Assembly.h"
#include "Core/Mesh.h"

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

  /// The cell of the vtkPolyData that each triangle is. Cells that name a point twice are no
  /// triangles and stand in no entry.
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
/// not finite, a cell that names a point that is not there, a polygon that cannot be cut into
/// triangles, more cells than 32-bit indices can count.
std::string ReadSurface(vtkPolyData* input, vtkPolyData* output, Surface& surface);

/// The first part of ReadSurface: checks `input` and makes `output` what a filter hands on. What is
/// wrong with the input, or nothing; then the output is empty.
std::string CutIntoTriangles(vtkPolyData* input, vtkPolyData* output);

/// Makes an assembly of a surface that ReadSurface has read (see MakeAssembly). What is wrong with
/// the patch ids, or nothing.
std::string AssembleSurface(
  vtkPolyData* output, const AssemblyParameters& parameters, Surface& surface);

/// Gives every point the position of the one that it is one with.
void ShareAmongCommon(const Surface& surface, std::vector<Vec3>& points);

/// The same for the arrays that the filters of Arris have added to points.
void ShareAmongCommon(const Surface& surface, vtkPolyData* output);

/// Replaces the output's points by moved ones, in the precision it has. Points whose new position
/// equals the old one keep every bit. Normals that came with the input do not fit the moved surface
/// any more: the arrays stay, but are no longer the ones to shade by.
void ReplacePoints(
  vtkPolyData* output, const std::vector<Vec3>& before, const std::vector<Vec3>& after);
}

#endif
