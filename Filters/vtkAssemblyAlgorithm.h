// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkAssemblyAlgorithm
 * @brief   what filters share that work on assemblies of meshes
 *
 * A non-manifold mesh, such as the surface between several materials, is a collection of 2-manifold
 * patches with common vertices. These filters take it in any of these forms:
 * - one vtkPolyData with a cell array that tells the patch of each cell (PatchArrayName);
 * - one with edges of three triangles or more and no such array: patches end there;
 * - open or closed meshes appended to each other, with points at equal positions (MergeTolerance);
 * - any of these in the blocks of a composite data set, which is one assembly and keeps its
 *   structure: each block of a vtkMultiBlockDataSet and each vtkPartitionedDataSet is a patch (or
 *   more) unless all of them have the patch array. Blocks that are no vtkPolyData pass.
 *
 * An inner vertex of a patch sees that patch only, a common vertex all that hold it. Common
 * vertices come out at one position, to the last bit, and with the same values in all arrays.
 * Patches are wound one way round for the computation, and come out as they were. Triangles that
 * coincide, as those between two closed meshes that touch, count as one.
 *
 * A closed mesh with neither patch array nor such edges is one patch.
 *
 * Errors (one vtkErrorMacro, then empty output): a patch array that does not hold one or two whole
 * numbers a cell, or the array asked for is missing. Cells with a negative number are a patch
 * of their own (or several). Vertices farther apart than MergeTolerance are not common: the patches
 * have free boundaries there. Triangles without area once their vertices are one move with these,
 * and have no other part in it.
 *
 * C.C.L. Wang, "Incremental Reconstruction of Sharp Edges on Mesh Surfaces", Computer-Aided Design
 * 38 (2006): section 4.1.
 *
 * @sa vtkSharpEdgeReconstruction vtkSurfaceNets3D
 */

#ifndef vtkAssemblyAlgorithm_h
#define vtkAssemblyAlgorithm_h

#include "ArrisFiltersModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

#include <memory>
#include <string>

namespace arris
{
class Blocks;
struct AssemblyParameters;
struct Surface;
}

class ARRISFILTERS_EXPORT vtkAssemblyAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkAssemblyAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The cell array that tells the patches of an assembly: one whole number a cell, or two for the
  /// materials on its two sides, in any order. Default: `PatchId`, and if there is none,
  /// `BoundaryLabels` of two components, as vtkSurfaceNets3D gives it. An empty name takes no
  /// array.
  vtkSetMacro(PatchArrayName, std::string);
  vtkGetMacro(PatchArrayName, std::string);
  ///@}

  ///@{
  /// Points of different patches, or on open edges, are common vertices up to this distance, as a
  /// part of the diagonal of the bounding box. They come out at the position of the first of them.
  /// Range: 0 and up; default 1e-6.
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /// What the last update found: the number of patches, of positions that several of them have in
  /// common, of edges of three triangles or more, of edges of one triangle, of patches that have
  /// only one side. 0 before the first.
  vtkGetMacro(NumberOfPatches, vtkIdType);
  vtkGetMacro(NumberOfCommonVertices, vtkIdType);
  vtkGetMacro(NumberOfJunctionEdges, vtkIdType);
  vtkGetMacro(NumberOfOpenEdges, vtkIdType);
  vtkGetMacro(NumberOfOneSidedPatches, vtkIdType);
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkAssemblyAlgorithm();
  ~vtkAssemblyAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Does the work on a vtkPolyData, which may be a composite data set put together.
  virtual int RequestMesh(
    vtkInformationVector** inputVector, vtkInformationVector* outputVector) = 0;

  /// Makes `output` what a filter hands on before it adds anything, and reads it as an assembly.
  /// What is wrong with it, or nothing.
  std::string ReadAssembly(vtkPolyData* input, vtkPolyData* output, arris::Surface& surface);

  /// How patches are told in this mesh.
  arris::AssemblyParameters AssemblyParametersFor(vtkPolyData* input) const;

  std::string PatchArrayName;
  double MergeTolerance;
  vtkIdType NumberOfPatches = 0;
  vtkIdType NumberOfCommonVertices = 0;
  vtkIdType NumberOfJunctionEdges = 0;
  vtkIdType NumberOfOpenEdges = 0;
  vtkIdType NumberOfOneSidedPatches = 0;

private:
  int RequestDataObject(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  int RequestBlocks(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  std::unique_ptr<arris::Blocks> TheBlocks;

  vtkAssemblyAlgorithm(const vtkAssemblyAlgorithm&) = delete;
  void operator=(const vtkAssemblyAlgorithm&) = delete;
};

#endif
