// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Blocks.h
/// The meshes in the blocks of a composite data set as one mesh, and back.

#ifndef arris_Blocks_h
#define arris_Blocks_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <utility>
#include <vector>

class vtkCompositeDataSet;
class vtkDataObject;

namespace arris
{
/// The cell array of Blocks::Whole() that tells the blocks apart: a number for each block of a
/// vtkMultiBlockDataSet and each member of a vtkPartitionedDataSetCollection. The partitions of a
/// vtkPartitionedDataSet are pieces of one mesh and bear the same.
constexpr const char* BlockArray = "arris::Block";

/// Keeps the whole from one execution to the next while the blocks are the same, so that it can be
/// recognised.
class Blocks
{
public:
  /// Puts the blocks together; what is wrong with one of them, or nothing.
  std::string Join(vtkCompositeDataSet* input);

  /// Triangles with the points of all vtkPolyData among the blocks, one block after the other, and
  /// the arrays that all of these have.
  vtkPolyData* Whole() const { return this->Joined; }

  /// Gives each block of `output` the structure of `input`, and of `whole`, which a filter has made
  /// of Whole(), its points and what arrays were added. Blocks that are no vtkPolyData pass.
  void Part(vtkCompositeDataSet* input, vtkPolyData* whole, vtkCompositeDataSet* output) const;

private:
  using State = std::vector<std::pair<vtkDataObject*, vtkMTimeType>>;
  struct Block
  {
    vtkSmartPointer<vtkPolyData> Triangles;
    vtkIdType FirstPoint;
  };

  void AppendBlocks(const std::vector<int>& numbers);
  void PartOne(vtkPolyData* whole, const Block& from, vtkPolyData* mesh) const;

  State Seen; // of the blocks that were put together
  std::vector<Block> Members;
  vtkSmartPointer<vtkPolyData> Joined = vtkSmartPointer<vtkPolyData>::New();
};
}

#endif
