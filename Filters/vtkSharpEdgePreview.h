// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSharpEdgePreview
 * @brief   see the sharp region and its skeleton before anything is sharpened
 *
 * Classifies and thins as the paper's method does (vtkUSSODFilter, vtkSharpThinningFilter) and
 * gives what the paper's figures show. No point moves. The parameters, picked points included, are
 * those of vtkSharpRegionAlgorithm. While only the angle changes, what does not depend on it is
 * kept.
 *
 * Output 0: the mesh with the point arrays `USSOD`, `NormalDeviation` (the active scalars),
 * `SharpRegion`, `ThinningRound` and `SkeletonRole` and the field data of the two filters.
 *
 * Output 1, the marks: the outline of the sharp region as lines, the skeleton as tubes, its
 * vertices as balls, larger at joints and ends. Cell array `SkeletonRole` (unsigned char, the
 * active scalars): 0 the outline, 1 tubes and branch vertices, 2 joints, 3 ends.
 *
 * Errors: those of vtkUSSODFilter.
 *
 * @sa vtkSharpRegionAlgorithm vtkSharpEdgeReconstruction
 */

#ifndef vtkSharpEdgePreview_h
#define vtkSharpEdgePreview_h

#include "ArrisFiltersModule.h" // for the export macro
#include "vtkSharpRegionAlgorithm.h"

class ARRISFILTERS_EXPORT vtkSharpEdgePreview : public vtkSharpRegionAlgorithm
{
public:
  static vtkSharpEdgePreview* New();
  vtkTypeMacro(vtkSharpEdgePreview, vtkSharpRegionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The radius of the tubes, in average edge lengths. Range: above 0; default 0.15.
  vtkSetMacro(TubeRadius, double);
  vtkGetMacro(TubeRadius, double);
  ///@}

  /// The outline, tubes and balls (output port 1).
  vtkPolyData* GetMarks();

protected:
  vtkSharpEdgePreview();
  ~vtkSharpEdgePreview() override = default;

  int RequestMesh(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  double TubeRadius = 0.15;

private:
  vtkSharpEdgePreview(const vtkSharpEdgePreview&) = delete;
  void operator=(const vtkSharpEdgePreview&) = delete;
};

#endif
