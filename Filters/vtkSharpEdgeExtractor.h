// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSharpEdgeExtractor
 * @brief   extract sharp feature curves, their corners and the faces between them
 *
 * Chooses a mesh's feature edges, joins them end to end to curves that are split at corners, and
 * numbers and measures the smooth faces between them. Feature edges are:
 *
 * - those whose two triangles' normals differ by more than FeatureAngle, and those above
 *   ContinuationAngle that go on where a feature would end, so that edges which fade into flat end
 *   where they fade. In a noisy neighbourhood (see NoiseFactor) the normals are means;
 * - the boundary of the mesh, and the edges where three or more triangles meet, if wanted;
 * - what closes gaps up to GapLength, and up to five times that where the surface as a whole folds
 *   between; but no tails shorter than TailLength, nor what bounds a face of at most four triangles
 *   that lies at one of fifty times as many, of about their size.
 *
 * Input: any polygonal data: the output of vtkSharpEdgeReconstruction, whose `SkeletonRole` is used
 * (an edge along the skeleton need only fold by more than ContinuationAngle; what ends freely away
 * from it must be ten average edge lengths long), a CAD tessellation, an STL soup (see
 * MergeTolerance), with boundaries and non-manifold edges.
 *
 * Output 0: the curves as polylines over the mesh's own points (but see ResampleStep), with these
 * points' arrays; each curve has points of its own; a closed one names its first point again at the
 * end. It runs so that, seen from outside, the face of the lower number is on its left, on the
 * boundary the only face.
 * Cell data: `CurveId` (int), `Length` (double), `DihedralAngle`, `MinimumDihedralAngle`,
 * `MaximumDihedralAngle` (double, degrees; the first is the mean by length; 0 on the boundary),
 * `CurveKind` (unsigned char: 0 convex, 1 concave, 2 boundary, 3 non-manifold), `Closed` (unsigned
 * char), `LeftSurfaceId`, `RightSurfaceId` (int, -1 for none). Point data: `DihedralAngle`
 * (double, degrees), `Tangent` (3 doubles, unit), `MeshPointId` (vtkIdType, the point of the input;
 * -1 between two of them).
 *
 * Output 1: the corners as vertices: where other than two feature edges meet, where a curve turns
 * by more than CornerAngle (unless it turns back within three edges, of a finely cut curve) or
 * changes from one of the kinds folded, boundary and non-manifold to another; and tips such as the
 * apex of a cone. Two that are less than a tenth of the edges of fine curves apart are one, to
 * which the curves of both go. Their points' arrays, and `Valence` (int: how many curves end there,
 * 0 for a tip), `CurveIds` (int, as many components as the largest valence, -1 beyond a corner's
 * own), `CornerKind` (unsigned char: 0 convex, 1 concave, 2 saddle, 3 none, for corners without
 * folded edges), `Tip` (unsigned char), `MeshPointId` (vtkIdType).
 *
 * Output 2: the mesh with the cell array `SurfaceId` (int): the smooth face that the curves bound,
 * numbered from 0 by descending area; -1 for cells without area, vertices and lines.
 *
 * Output 3: a vtkTable with one row a face, by SurfaceId: `Area`, `Triangles`, `BoundaryLoops`
 * (connected pieces of its border), and with FitPrimitives `Primitive` ("plane", "sphere",
 * "cylinder", "cone", "torus" or "free-form"), `Point` (on the plane or the axis, the centre, a
 * cone's apex), `Axis` (unit; a plane's normal), `Radius` (of a torus, of the circle in the middle
 * of its tube), `MinorRadius` (of the tube), `HalfAngle` (of a cone, degrees), `Residual` (RMS
 * distance of the face's points from the shape, length). What a shape does not have is 0.
 *
 * Errors (one vtkErrorMacro, then empty output): no triangles (an empty piece of several is none),
 * triangles of which no two share an edge even after merging, a point that is not finite, a cell
 * that names a missing point or cannot be cut into triangles, a parameter out of its range.
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

#include <string>

class vtkTable;

namespace arris
{
struct FeatureCriteria;
}

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
  /// Where a feature ends, edges that go on straight are features too if their dihedral angle is
  /// above this, in degrees. Range: 0 to FeatureAngle; default 0, which takes half the
  /// FeatureAngle.
  vtkSetMacro(ContinuationAngle, double);
  vtkGetMacro(ContinuationAngle, double);
  ///@}

  ///@{
  /// Edges with a dihedral angle above this are no features, in degrees: to leave out what is
  /// folded back. Range: FeatureAngle to 180; default 180.
  vtkSetMacro(MaximumAngle, double);
  vtkGetMacro(MaximumAngle, double);
  ///@}

  ///@{
  /// A curve is split where it turns by more than this, in degrees; 180 for never. Range: above 0,
  /// at most 180; default 60.
  vtkSetMacro(CornerAngle, double);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /// Where the mesh folds both up and down by more than an edge's angle over this, the edge is
  /// judged by the mean normals up to three edge lengths to both sides, in which noise cancels out.
  /// Range: from 0; default 30. 0 takes every fold for shape.
  vtkSetMacro(NoiseFactor, double);
  vtkGetMacro(NoiseFactor, double);
  ///@}

  ///@{
  /// Whether edges with one triangle, and with three and more, are features. Default: on.
  vtkSetMacro(BoundaryEdges, bool);
  vtkGetMacro(BoundaryEdges, bool);
  vtkBooleanMacro(BoundaryEdges, bool);
  vtkSetMacro(NonManifoldEdges, bool);
  vtkGetMacro(NonManifoldEdges, bool);
  vtkBooleanMacro(NonManifoldEdges, bool);
  ///@}

  ///@{
  /// A free end is carried on along the mesh to a feature ahead of it that is no farther away, as a
  /// length; to one straight ahead that is up to five times as far, where the surface folds by more
  /// than ContinuationAngle between them, seen from as far to both sides. 0 closes no gaps.
  /// Default: -1, negative for one average edge length.
  vtkSetMacro(GapLength, double);
  vtkGetMacro(GapLength, double);
  ///@}

  ///@{
  /// What ends freely and is shorter than this, up to where it turns or other features meet it, is
  /// no feature, as a length; 0 keeps it. Default: -1, negative for two average edge lengths.
  vtkSetMacro(TailLength, double);
  vtkGetMacro(TailLength, double);
  ///@}

  ///@{
  /// Curves between true corners, and closed ones, that are shorter than this are no features, as a
  /// length. Range: from 0; default 0, which keeps all.
  vtkSetMacro(MinimumLength, double);
  vtkGetMacro(MinimumLength, double);
  ///@}

  ///@{
  /// Points on open edges that are within this distance of each other are taken for one, as a part
  /// of the diagonal of the mesh's bounding box. Output 2 keeps its points all the same. Range:
  /// from 0, which takes points in one place for one; default 1e-6.
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /// The distance of the points along a curve, as a length, or as near to it as goes evenly; arrays
  /// are interpolated. Range: from 0, with an error where curves would get more than a million
  /// points above their own; default 0, which keeps the mesh's points.
  vtkSetMacro(ResampleStep, double);
  vtkGetMacro(ResampleStep, double);
  ///@}

  ///@{
  /// Whether to fit shapes to the faces. Default: on.
  vtkSetMacro(FitPrimitives, bool);
  vtkGetMacro(FitPrimitives, bool);
  vtkBooleanMacro(FitPrimitives, bool);
  ///@}

  ///@{
  /// A shape fits a face if the RMS distance of its points is within so many mean edge lengths of
  /// the face (and the normals agree). Range: from 0; default 0.03.
  vtkSetMacro(FitTolerance, double);
  vtkGetMacro(FitTolerance, double);
  ///@}

  /// The corners (output port 1).
  vtkPolyData* GetCorners();

  /// The mesh with its surface ids (output port 2).
  vtkPolyData* GetSurfaces();

  /// The table of the faces (output port 3).
  vtkTable* GetFaces();

protected:
  vtkSharpEdgeExtractor();
  ~vtkSharpEdgeExtractor() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double FeatureAngle;
  double ContinuationAngle = 0.0;
  double MaximumAngle = 180.0;
  double CornerAngle;
  double NoiseFactor;
  bool BoundaryEdges = true;
  bool NonManifoldEdges = true;
  double GapLength = -1.0;
  double TailLength = -1.0;
  double MinimumLength = 0.0;
  double MergeTolerance;
  double ResampleStep = 0.0;
  bool FitPrimitives = true;
  double FitTolerance;

private:
  /// What is wrong with the parameters, or nothing.
  std::string ProblemWithParameters() const;

  /// The parameters as the method takes them.
  void FillCriteria(double averageEdgeLength, arris::FeatureCriteria& criteria) const;

  vtkSharpEdgeExtractor(const vtkSharpEdgeExtractor&) = delete;
  void operator=(const vtkSharpEdgeExtractor&) = delete;
};

#endif
