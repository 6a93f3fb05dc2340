// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkUSSODFilter
 * @brief   find the regions of a mesh where sampling took sharp edges away
 *
 * Computes the Uniformly Supported Second-Order Difference of each vertex: the largest difference
 * between two triangle normals inside a window of radius λ around it,
 * τ(v) = max(1 - ni.nj) / λ (Eq. 2 of the paper below). A vertex is in the sharp region when the
 * normals in its window deviate by at least SharpAngle. Window and angle may be left to picked
 * points: see vtkSharpRegionAlgorithm, which has the parameters.
 *
 * Input: polygonal data. Strips and polygons are cut into triangles (vtkTriangleFilter's rule)
 * whose cell data is that of what they were cut from; vertices and lines pass. Output: the same,
 * with all its arrays, and
 * - point array `USSOD` (double, 1/length): τ;
 * - point array `NormalDeviation` (double, degrees, 0 to 180): acos(1 - λτ);
 * - point array `SharpRegion` (unsigned char): 1 where NormalDeviation reaches SharpAngle;
 * - field data `Lambda` (length), `SharpAngle` (degrees), `AverageEdgeLength` (length),
 *   `ClassificationSeconds` (0 if only the angle has changed: τ is kept).
 *
 * Slivers lower than a thousandth of the average edge length have no normal that can be trusted and
 * do not count.
 *
 * Errors (one vtkErrorMacro, then empty output): a point that is not finite, a cell that names a
 * missing point or cannot be cut into triangles, a parameter out of its range,
 * picked points that contradict each other.
 *
 * C.C.L. Wang, "Incremental Reconstruction of Sharp Edges on Mesh Surfaces", Computer-Aided Design
 * 38 (2006): sections 3.1 and 4.2.
 *
 * @sa vtkSharpRegionAlgorithm vtkSharpThinningFilter vtkSharpeningFilter vtkSharpEdgeReconstruction
 */

#ifndef vtkUSSODFilter_h
#define vtkUSSODFilter_h

#include "ArrisFiltersModule.h" // for the export macro
#include "vtkSharpRegionAlgorithm.h"

class ARRISFILTERS_EXPORT vtkUSSODFilter : public vtkSharpRegionAlgorithm
{
public:
  static vtkUSSODFilter* New();
  vtkTypeMacro(vtkUSSODFilter, vtkSharpRegionAlgorithm);

protected:
  vtkUSSODFilter() = default;
  ~vtkUSSODFilter() override = default;

  int RequestMesh(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkUSSODFilter(const vtkUSSODFilter&) = delete;
  void operator=(const vtkUSSODFilter&) = delete;
};

#endif
