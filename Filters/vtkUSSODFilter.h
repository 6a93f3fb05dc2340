// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkUSSODFilter
 * @brief   find the regions of a mesh where sampling took sharp edges away
 *
 * Computes the Uniformly Supported Second-Order Difference of each vertex: the largest difference
 * between two triangle normals inside a window of radius λ around it,
 * τ(v) = max(1 - ni.nj) / λ (Eq. 2 of the paper below). A vertex is in the sharp region when the
 * normals in its window deviate by at least SharpAngle.
 *
 * Input: polygonal data. Strips and polygons are cut into triangles (vtkTriangleFilter's rule)
 * whose cell data is that of what they were cut from; vertices and lines pass. Output: the same,
 * with all its arrays, and
 * - point array `USSOD` (double, 1/length): τ;
 * - point array `NormalDeviation` (double, degrees, 0 to 180): acos(1 - λτ);
 * - point array `SharpRegion` (unsigned char): 1 where NormalDeviation reaches SharpAngle;
 * - field data `Lambda` (length), `SharpAngle` (degrees), `AverageEdgeLength` (length),
 *   `ClassificationSeconds`.
 *
 * Slivers lower than a thousandth of the average edge length have no normal that can be trusted and
 * do not count.
 *
 * Errors (one vtkErrorMacro, then empty output): a point that is not finite, a cell that names a
 * missing point or cannot be cut into triangles, a parameter out of its range.
 *
 * C.C.L. Wang, "Incremental Reconstruction of Sharp Edges on Mesh Surfaces", Computer-Aided Design
 * 38 (2006): sections 3.1 and 4.2.
 *
 * @sa vtkSharpThinningFilter vtkSharpeningFilter vtkSharpEdgeReconstruction
 */

#ifndef vtkUSSODFilter_h
#define vtkUSSODFilter_h

#include "ArrisFiltersModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

class ARRISFILTERS_EXPORT vtkUSSODFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkUSSODFilter* New();
  vtkTypeMacro(vtkUSSODFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The window radius λ in the length unit of the points. 0, the default, takes WindowRatio times
  /// the average edge length instead. Range: 0 and up.
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

  ///@{
  /// The normal deviation in the window from which a vertex counts as sharp, in degrees: θ with
  /// κλ = 1 - cos θ (section 4.2). Range: above 0, at most 180; default 41.41, the paper's 0.25.
  vtkSetMacro(SharpAngle, double);
  vtkGetMacro(SharpAngle, double);
  ///@}

  ///@{
  /// How the triangles of a window are found. CONNECTED (the default) walks the mesh outward from
  /// the vertex and does not see a wall that is near in space but not connected within the window;
  /// SPATIAL takes all triangles in reach, as the paper does, by vtkStaticCellLocator.
  enum WindowSearchType
  {
    CONNECTED = 0,
    SPATIAL = 1
  };
  vtkSetMacro(WindowSearch, int);
  vtkGetMacro(WindowSearch, int);
  void SetWindowSearchToConnected() { this->SetWindowSearch(CONNECTED); }
  void SetWindowSearchToSpatial() { this->SetWindowSearch(SPATIAL); }
  ///@}

  ///@{
  /// The threshold κ = (1 - cos SharpAngle) / λ that the last update compared τ with, 1/length.
  vtkGetMacro(Kappa, double);
  ///@}

protected:
  vtkUSSODFilter();
  ~vtkUSSODFilter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Window;
  double WindowRatio;
  double SharpAngle;
  int WindowSearch;
  double Kappa = 0.0;

private:
  vtkUSSODFilter(const vtkUSSODFilter&) = delete;
  void operator=(const vtkUSSODFilter&) = delete;
};

#endif
