// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSharpEdgeReconstruction
 * @brief   give a mesh back the sharp edges that sampling took from it
 *
 * Iso-surfaces, level sets, voxel booleans and remeshing chamfer or round sharp edges and corners.
 * This filter finds the damaged regions, thins them to a skeleton and moves their vertices to where
 * the intact faces around say that edges and corners belong: vtkUSSODFilter, vtkSharpThinningFilter
 * and vtkSharpeningFilter in one, sharing one connectivity.
 *
 * Input: polygonal data, closed or with boundary. Strips and polygons are cut into triangles
 * (vtkTriangleFilter's rule) whose cell data is that of what they were cut from; vertices and lines
 * pass. Output: the mesh with the same triangles and moved points, all the input's arrays, and
 * the point arrays `USSOD`, `NormalDeviation`, `SharpRegion`, `ThinningRound`, `SkeletonRole` and
 * `Displacement` as the three filters describe them, and the field data `Lambda`, `SharpAngle`,
 * `AverageEdgeLength`, `ClassificationSeconds`, `ThinningSeconds` and `SharpeningSeconds`. The
 * robust method has a window of its own at each vertex (0.75 local edge lengths; `Lambda` is the
 * mean) and no `SharpAngle`; its `ThinningRound` is the distance in edges from the intact surface.
 *
 * Vertices outside the sharp region keep their exact coordinates; points keep their precision;
 * normals that came with the input stay as arrays but not as the active ones, as they no longer
 * fit. The output is the same to the last bit for any number of threads and any SMP backend.
 *
 * Errors (one vtkErrorMacro, then empty output): a point that is not finite, a cell that names a
 * missing point or cannot be cut into triangles, a parameter out of its range.
 *
 * C.C.L. Wang, "Incremental Reconstruction of Sharp Edges on Mesh Surfaces", Computer-Aided Design
 * 38 (2006).
 *
 * @sa vtkUSSODFilter vtkSharpThinningFilter vtkSharpeningFilter vtkSharpEdgeExtractor
 */

#ifndef vtkSharpEdgeReconstruction_h
#define vtkSharpEdgeReconstruction_h

#include "ArrisFiltersModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

class ARRISFILTERS_EXPORT vtkSharpEdgeReconstruction : public vtkPolyDataAlgorithm
{
public:
  static vtkSharpEdgeReconstruction* New();
  vtkTypeMacro(vtkSharpEdgeReconstruction, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// ROBUST (the default) needs no parameters: its windows follow the local edge length, faces are
  /// carried on with their curvature, and no triangle is left folded over or cutting another.
  /// Window, WindowRatio, SharpAngle and WindowSearch do not apply to it. PAPER follows the paper
  /// step by step.
  enum MethodType
  {
    PAPER = 0,
    ROBUST = 1
  };
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToPaper() { this->SetMethod(PAPER); }
  void SetMethodToRobust() { this->SetMethod(ROBUST); }
  ///@}

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

protected:
  vtkSharpEdgeReconstruction();
  ~vtkSharpEdgeReconstruction() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Method;
  double Window;
  double WindowRatio;
  double SharpAngle;
  int WindowSearch;

private:
  vtkSharpEdgeReconstruction(const vtkSharpEdgeReconstruction&) = delete;
  void operator=(const vtkSharpEdgeReconstruction&) = delete;
};

#endif
