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
 * - `Rounding` (field): 0 where sampling has cut the edges off, up to 1 where it has rounded them;
 * - `BendTriangleSize` (field): of a rough or rounded mesh, the mean area of triangles inside the
 *   sharp region by that outside it (otherwise 1); below 0.75 its bends are meant, as of a scanned
 *   casting, and left alone: `BendsAreMeant` (field) is 1, unless a window or an angle is set.
 *
 * A rough mesh (noise, a segmentation) is recognised by itself and worked on in a smoothed copy; a
 * vtkWarningMacro says so, and another one that bends were left alone because they are meant.
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
 * @sa vtkSharpRegionAlgorithm vtkUSSODFilter vtkSharpThinningFilter vtkSharpeningFilter
 * vtkSharpEdgeExtractor
 */

#ifndef vtkSharpEdgeReconstruction_h
#define vtkSharpEdgeReconstruction_h

#include "ArrisFiltersModule.h" // for the export macro
#include "vtkSharpRegionAlgorithm.h"

namespace arris
{
class Monitor;
}

class ARRISFILTERS_EXPORT vtkSharpEdgeReconstruction : public vtkSharpRegionAlgorithm
{
public:
  static vtkSharpEdgeReconstruction* New();
  vtkTypeMacro(vtkSharpEdgeReconstruction, vtkSharpRegionAlgorithm);
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

  // Window, WindowRatio and SharpAngle are those of vtkSharpRegionAlgorithm, but 0 leaves them to
  // the method. It is the default of all three. The window: PAPER takes 0.75 average edge lengths,
  // ROBUST 0.75 times the *local* edge length; a set one is the same everywhere. The angle: for
  // PAPER the normal deviation in the window, 41.41 if 0; for ROBUST the turn between the smooth
  // faces on both sides, if 0 it is 16, of segmentations 13, of noise 22. Picked points set both.

  ///@{
  /// Whether on a rough mesh the smooth faces are moved onto its smoothed copy as well (ROBUST).
  /// Off, the default, leaves every vertex outside the sharp region where it is.
  vtkSetMacro(Denoise, bool);
  vtkGetMacro(Denoise, bool);
  vtkBooleanMacro(Denoise, bool);
  ///@}

  ///@{
  /// Whether edges inside the sharp region may be flipped (ROBUST) where the triangles of a face
  /// have no room otherwise. Points and cells keep their numbers and arrays; cells of the region
  /// may get other corners. Off, the default, keeps the connectivity. The field value EdgeFlips
  /// tells how many were.
  vtkSetMacro(AllowEdgeFlips, bool);
  vtkGetMacro(AllowEdgeFlips, bool);
  vtkBooleanMacro(AllowEdgeFlips, bool);
  ///@}

protected:
  vtkSharpEdgeReconstruction();
  ~vtkSharpEdgeReconstruction() override = default;

  int RequestMesh(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  int Method = ROBUST;
  bool Denoise = false;
  bool AllowEdgeFlips = false;

private:
  bool RecoverRobustly(vtkPolyData* input, const arris::Surface& surface,
    const arris::ClassificationParameters& chosen, const arris::Monitor& monitor,
    vtkPolyData* output);

  vtkSharpEdgeReconstruction(const vtkSharpEdgeReconstruction&) = delete;
  void operator=(const vtkSharpEdgeReconstruction&) = delete;
};

#endif
