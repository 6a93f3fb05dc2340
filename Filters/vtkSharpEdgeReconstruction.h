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
 * `AverageEdgeLength`, `ClassificationSeconds`, `ThinningSeconds` and `SharpeningSeconds`.
 *
 * The robust method gives an account of itself in three more point arrays and two field values:
 * - `Window`: the radius of the vertex's window (0.75 local edge lengths unless set; `Lambda` is
 * the mean); `ThinningRound` is the distance in edges from the intact surface;
 * - `EdgeAngle`: the turn between the smooth faces on both sides of the vertex, in degrees, 0 where
 *   its window is flat. An edge begins at the field value `SharpAngle`;
 * - `Outcome`: 0 intact; 1 moved; 2 in the sharp region but right already; left alone in it as 3 no
 *   intact face is near, or 4 it belongs too far away; 5 held back, wholly or in part, as a
 * triangle would have folded over or cut another; 6 outside the sharp region, but denoised;
 * - `Roughness` (field): 0 for a mesh that is smooth away from its edges, up to 1 for a rough one;
 * - `Rounding` (field): 0 where sampling has cut the edges off, up to 1 where it has rounded them.
 *
 * A rough mesh (noise, a segmentation) is recognised by itself and worked on in a smoothed copy; a
 * vtkWarningMacro says so.
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

namespace arris
{
class Monitor;
struct Surface;
}

class ARRISFILTERS_EXPORT vtkSharpEdgeReconstruction : public vtkPolyDataAlgorithm
{
public:
  static vtkSharpEdgeReconstruction* New();
  vtkTypeMacro(vtkSharpEdgeReconstruction, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// ROBUST (the default) needs no parameters: its windows follow the local edge length, faces are
  /// carried on with their curvature, and no triangle is left folded over or cutting another.
  /// Window, WindowRatio and SharpAngle are obeyed where they are set; WindowSearch does not apply
  /// to it. PAPER follows the paper step by step.
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
  /// The window radius λ in the length unit of the points, the same everywhere. 0, the default,
  /// leaves it to WindowRatio. Range: 0 and up.
  vtkSetMacro(Window, double);
  vtkGetMacro(Window, double);
  ///@}

  ///@{
  /// The window radius λ as a multiple of the average edge length, used while Window is 0. 0, the
  /// default, leaves it to the method: PAPER takes 0.75, ROBUST 0.75 times the *local* edge length.
  /// The paper uses 0.5 to 1.5 and starts from 1 for regular, 1.5 for irregular meshes. Range: 0
  /// and up.
  vtkSetMacro(WindowRatio, double);
  vtkGetMacro(WindowRatio, double);
  ///@}

  ///@{
  /// The angle from which on an edge is sharp, in degrees. For PAPER the normal deviation in the
  /// window: θ with κλ = 1 - cos θ (section 4.2). For ROBUST the turn between the smooth faces on
  /// both sides. 0, the default, leaves it to the method: PAPER takes 41.41, the paper's 0.25;
  /// ROBUST 16, on rough meshes up to 22. Range: 0 to 180.
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
  /// Whether on a rough mesh the smooth faces are moved onto its smoothed copy as well (ROBUST).
  /// Off, the default, leaves every vertex outside the sharp region where it is.
  vtkSetMacro(Denoise, bool);
  vtkGetMacro(Denoise, bool);
  vtkBooleanMacro(Denoise, bool);
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
  bool Denoise;

private:
  bool RecoverRobustly(
    const arris::Surface& surface, const arris::Monitor& monitor, vtkPolyData* output);

  vtkSharpEdgeReconstruction(const vtkSharpEdgeReconstruction&) = delete;
  void operator=(const vtkSharpEdgeReconstruction&) = delete;
};

#endif
