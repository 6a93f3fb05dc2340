// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkSharpRegionAlgorithm
 * @brief   what filters share that tell the sharp vertices of a mesh from the smooth ones
 *
 * Two parameters decide what is sharp: the radius λ of the window around a vertex, and how far the
 * normals in it must deviate. They are given as numbers or, as the paper has it, by picked points:
 * points expected to be sharp and points expected to be smooth, each as positions
 * (SetPickedPointsSharp, SetPickedPointsSmooth) or as a selection of points or cells (input ports 1
 * and 2, both optional): by indices, global or pedigree ids, values, thresholds, locations or
 * frustum, inverted or combined. Selections made by a query or of whole blocks are errors.
 *
 * - With sharp picks, the window grows from 0.5 average edge lengths on, up to 2, until all of them
 *   deviate by SharpAngle or more; the threshold κ is then the least τ of them, and so the angle
 *   used is that of the least sharp one. If no window makes them so sharp, the smallest one counts
 *   in which the least sharp pick is about as sharp as it gets, and the angle used is less than
 *   SharpAngle. Window and WindowRatio do not matter.
 * - Smooth picks bound the window: one in which a smooth pick is not smoother than a sharp one,
 *   by a degree, is passed over.
 * - With smooth picks only, the window shrinks until none of them reaches SharpAngle; if 0.5
 *   average edge lengths are not small enough, the angle used is the least that leaves them out.
 *
 * A picked position is the nearest vertex of a triangle, a picked cell the sharpest of its points.
 * GetUsedWindow, GetUsedWindowRatio, GetUsedSharpAngle and GetKappa tell what the last update
 * chose; the field data `Lambda` and `SharpAngle` hold the same.
 *
 * Errors (one vtkErrorMacro, then empty output): a smooth pick that is not smoother than a sharp
 * one whatever the window (the message names both), a sharp pick where the surface is flat, a
 * position more than 5 average edge lengths away from the mesh, a selection of neither points nor
 * cells.
 *
 * C.C.L. Wang, "Incremental Reconstruction of Sharp Edges on Mesh Surfaces", Computer-Aided Design
 * 38 (2006): section 4.2.
 *
 * @sa vtkUSSODFilter vtkSharpEdgeReconstruction
 */

#ifndef vtkSharpRegionAlgorithm_h
#define vtkSharpRegionAlgorithm_h

#include "ArrisFiltersModule.h" // for the export macro
#include "vtkAssemblyAlgorithm.h"

#include <vtkSmartPointer.h> // for the picked points

#include <memory>
#include <string>

class vtkPoints;
class vtkSelection;

namespace arris
{
class Classification;
struct ClassificationParameters;
struct PickedPoints;
struct Surface;
}

class ARRISFILTERS_EXPORT vtkSharpRegionAlgorithm : public vtkAssemblyAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSharpRegionAlgorithm, vtkAssemblyAlgorithm);
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
  /// default 0.75; but see vtkSharpEdgeReconstruction.
  vtkSetMacro(WindowRatio, double);
  vtkGetMacro(WindowRatio, double);
  ///@}

  ///@{
  /// The normal deviation in the window from which a vertex counts as sharp, in degrees: θ with
  /// κλ = 1 - cos θ (section 4.2). Range: above 0, at most 180; default 41.41, the paper's 0.25;
  /// but see vtkSharpEdgeReconstruction.
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
  /// Positions where the mesh is expected to be sharp, and where smooth, in its coordinates.
  /// Default: null, for none.
  virtual void SetPickedPointsSharp(vtkPoints* positions);
  vtkPoints* GetPickedPointsSharp() const { return this->PickedPointsSharp; }
  virtual void SetPickedPointsSmooth(vtkPoints* positions);
  vtkPoints* GetPickedPointsSmooth() const { return this->PickedPointsSmooth; }
  ///@}

  ///@{
  /// The same as selections (input ports 1 and 2), which may come besides positions.
  void SetPickedPointsSharpConnection(vtkAlgorithmOutput* selection);
  void SetPickedPointsSharpData(vtkSelection* selection);
  void RemovePickedPointsSharpInput();
  void SetPickedPointsSmoothConnection(vtkAlgorithmOutput* selection);
  void SetPickedPointsSmoothData(vtkSelection* selection);
  void RemovePickedPointsSmoothInput();
  ///@}

  ///@{
  /// What the last update used, given or picked: λ (length), λ in average edge lengths, the angle
  /// (degrees) and the threshold κ = (1 - cos angle) / λ (1/length). 0 before the first.
  vtkGetMacro(UsedWindow, double);
  vtkGetMacro(UsedWindowRatio, double);
  vtkGetMacro(UsedSharpAngle, double);
  vtkGetMacro(Kappa, double);
  ///@}

  /// Changes with the picked points too.
  vtkMTimeType GetMTime() override;

protected:
  vtkSharpRegionAlgorithm();
  ~vtkSharpRegionAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /// What is wrong with the window and the angle, or nothing.
  std::string ProblemWithParameters() const;

  /// The parameters to classify by: given, or what the picked points ask for. What is wrong with
  /// the picks, or nothing. The getters of what was used tell them from then on. A WindowRatio or
  /// a SharpAngle of 0 stands for the paper's.
  std::string ChooseParameters(vtkInformationVector** inputVector, const arris::Surface& surface,
    arris::ClassificationParameters& parameters);

  /// Sets what the getters tell of the last update.
  void SetUsed(double window, double averageEdgeLength, double sharpAngle);

  double Window = 0.0;
  double WindowRatio;
  double SharpAngle;
  int WindowSearch = CONNECTED;
  vtkSmartPointer<vtkPoints> PickedPointsSharp;
  vtkSmartPointer<vtkPoints> PickedPointsSmooth;

  bool PointsArePicked = false; ///< in the last update
  double UsedWindow = 0.0;
  double UsedWindowRatio = 0.0;
  double UsedSharpAngle = 0.0;
  double Kappa = 0.0;

  /// Keeps what does not change with the angle.
  std::unique_ptr<arris::Classification> Classifier;

private:
  vtkSharpRegionAlgorithm(const vtkSharpRegionAlgorithm&) = delete;
  void operator=(const vtkSharpRegionAlgorithm&) = delete;
};

#endif
