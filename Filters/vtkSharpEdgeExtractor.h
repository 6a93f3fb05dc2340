// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSharpEdgeExtractor
 * @brief   extract sharp feature curves, their corners and the faces between them
 *
 * Finds the mesh edges whose two triangles' normals differ by more than FeatureAngle, and those
 * where three or more triangles meet, and joins them end to end to curves that are split at
 * corners.
 *
 * Input: any polygonal data, for instance the output of vtkSharpEdgeReconstruction.
 *
 * Output 0: the curves as polylines over the mesh's own points, with these points' arrays; closed
 * curves name their first point again at the end. Cell data: `CurveId` (int), `DihedralAngle`
 * (double, degrees, mean over the curve by length), `Length` (double).
 *
 * Output 1: the corners as vertices: where other than two feature edges meet, and where a curve
 * turns by more than CornerAngle. Their points' arrays, and `Valence` (int): how many feature edges
 * meet.
 *
 * Output 2: the mesh with the cell array `SurfaceId` (int): the smooth face that the curves bound,
 * numbered from 0 by descending area; -1 for cells without area, vertices and lines.
 *
 * Errors (one vtkErrorMacro, then empty output): a point that is not finite, a cell that names a
 * missing point or cannot be cut into triangles, a parameter out of its range.
 *
 * C.C.L. Wang, "Incremental Reconstruction of Sharp Edges on Mesh Surfaces", Computer-Aided Design
 * 38 (2006): section 5, last paragraph.
 *
 * @sa vtkFeatureEdges vtkSharpEdgeReconstruction
 */

#ifndef vtkSharpEdgeExtractor_h
#define vtkSharpEdgeExtractor_h

#include "ArrisFiltersModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

class ARRISFILTERS_EXPORT vtkSharpEdgeExtractor : public vtkPolyDataAlgorithm
{
public:
  static vtkSharpEdgeExtractor* New();
  vtkTypeMacro(vtkSharpEdgeExtractor, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Edges with a dihedral angle (between the normals) above this are features, in degrees. For the
  /// paper's sharp edges give the SharpAngle that the mesh was recovered with. Range: above 0, at
  /// most 180; default 30.
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /// A curve is split where it turns by more than this, in degrees; 180 for never. Range: above 0,
  /// at most 180; default 60.
  vtkSetMacro(CornerAngle, double);
  vtkGetMacro(CornerAngle, double);
  ///@}

  /// The corners (output port 1).
  vtkPolyData* GetCorners();

  /// The mesh with its surface ids (output port 2).
  vtkPolyData* GetSurfaces();

protected:
  vtkSharpEdgeExtractor();
  ~vtkSharpEdgeExtractor() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double FeatureAngle;
  double CornerAngle;

private:
  vtkSharpEdgeExtractor(const vtkSharpEdgeExtractor&) = delete;
  void operator=(const vtkSharpEdgeExtractor&) = delete;
};

#endif
