// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSharpeningFilter
 * @brief   move the vertices of a thinned sharp region to where its edges belong
 *
 * Replays the rounds of thinning: each removed vertex goes to the position of least squared
 * distance to the planes of the static triangles near it (the geometry predictor), and becomes
 * static; then the branch vertices of the skeleton follow, and last its joints. Vertices outside
 * the sharp region keep their exact coordinates, and the triangles their points.
 *
 * Input: a mesh with the point array `ThinningRound` (SetInputArrayToProcess index 0), as
 * vtkSharpThinningFilter gives it. Output: the same mesh with moved points and
 * - point array `Displacement` (3 doubles, length): output minus input position;
 * - field data `SharpeningSeconds`.
 * Points keep their precision. Normals that came with the input no longer fit: they stay as arrays
 * but not as the active normals.
 *
 * Errors (one vtkErrorMacro, then empty output): a point that is not finite, a cell that names a
 * missing point or cannot be cut into triangles, a parameter out of its range. Likewise a missing
 * ThinningRound array, or one with values that are neither -1 nor 1 and up.
 *
 * C.C.L. Wang, "Incremental Reconstruction of Sharp Edges on Mesh Surfaces", Computer-Aided Design
 * 38 (2006): sections 3.2, 4.3 and 4.5.
 *
 * @sa vtkSharpThinningFilter vtkSharpEdgeReconstruction
 */

#ifndef vtkSharpeningFilter_h
#define vtkSharpeningFilter_h

#include "ArrisFiltersModule.h" // for the export macro
#include "vtkAssemblyAlgorithm.h"

class ARRISFILTERS_EXPORT vtkSharpeningFilter : public vtkAssemblyAlgorithm
{
public:
  static vtkSharpeningFilter* New();
  vtkTypeMacro(vtkSharpeningFilter, vtkAssemblyAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The window radius λ in the length unit of the points. 0, the default, takes the
  /// field data `Lambda` that vtkUSSODFilter left, or without it WindowRatio times the average edge
  /// length. Range: 0 and up.
  vtkSetMacro(Window, double);
  vtkGetMacro(Window, double);
  ///@}

  ///@{
  /// The window radius λ as a multiple of the average edge length, used while Window is 0. The
  /// paper uses 0.5 to 1.5 and starts from 1 for regular, 1.5 for irregular meshes. Range: above 0;
  /// default 0.75.
  vtkSetMacro(WindowRatio, double);
  vtkGetMacro(WindowRatio, double);
  ///@}

protected:
  vtkSharpeningFilter();
  ~vtkSharpeningFilter() override = default;

  int RequestMesh(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double Window;
  double WindowRatio;

private:
  vtkSharpeningFilter(const vtkSharpeningFilter&) = delete;
  void operator=(const vtkSharpeningFilter&) = delete;
};

#endif
