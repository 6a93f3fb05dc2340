// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSharpThinningFilter
 * @brief   thin the sharp region of a mesh to its skeleton
 *
 * Removes vertices from the sharp region, round by round from its border inwards, as long as that
 * does not disconnect it locally; vertices on the boundary of the mesh and the tails of the
 * skeleton stay. What is left is one edge wide. Topology alone decides, so no point moves.
 *
 * Input: a mesh with the point array `SharpRegion` (SetInputArrayToProcess index 0; non-zero is in
 * the region), as vtkUSSODFilter gives it. Where it also has `USSOD` (index 1), the vertices of a
 * round are tried in ascending order of it, else in order of storage.
 *
 * Output 0: the mesh with
 * - point array `ThinningRound` (int): the round, 1 and up, that removed the vertex; -1 never in
 * the region; the largest value is the skeleton;
 * - point array `SkeletonRole` (unsigned char): 0 none, 1 branch (two sharp edges), 2 joint (three
 * or more), 3 end (one or none).
 * - field data `ThinningSeconds`.
 *
 * Output 1: the skeleton as polylines that end at joints and ends, with the points' arrays, and the
 * point array `SkeletonRole` among them.
 *
 * Errors (one vtkErrorMacro, then empty output): a point that is not finite, a cell that names a
 * missing point or cannot be cut into triangles, a parameter out of its range. Likewise a missing
 * SharpRegion array.
 *
 * C.C.L. Wang, "Incremental Reconstruction of Sharp Edges on Mesh Surfaces", Computer-Aided Design
 * 38 (2006): sections 3.3 and 4.4, and the appendix.
 *
 * @sa vtkUSSODFilter vtkSharpeningFilter
 */

#ifndef vtkSharpThinningFilter_h
#define vtkSharpThinningFilter_h

#include "ArrisFiltersModule.h" // for the export macro
#include "vtkAssemblyAlgorithm.h"

class ARRISFILTERS_EXPORT vtkSharpThinningFilter : public vtkAssemblyAlgorithm
{
public:
  static vtkSharpThinningFilter* New();
  vtkTypeMacro(vtkSharpThinningFilter, vtkAssemblyAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The skeleton (output port 1).
  vtkPolyData* GetSkeleton();

protected:
  vtkSharpThinningFilter();
  ~vtkSharpThinningFilter() override = default;

  int RequestMesh(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkSharpThinningFilter(const vtkSharpThinningFilter&) = delete;
  void operator=(const vtkSharpThinningFilter&) = delete;
};

#endif
