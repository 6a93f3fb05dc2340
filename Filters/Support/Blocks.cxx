// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Blocks.h"

#include "Support/Surface.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <map>

namespace arris
{
namespace
{
/// Calls visit(iterator) for each block that is not empty.
template <typename Visit>
void ForEachBlock(vtkCompositeDataSet* data, Visit&& visit)
{
  const auto iterator = vtk::TakeSmartPointer(data->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    visit(iterator.Get());
  }
}

/// Which number a block has among the materials of a composite data set.
class Numbering
{
public:
  explicit Numbering(vtkCompositeDataSet* input)
    : IsOneMesh(vtkPartitionedDataSet::SafeDownCast(input) != nullptr)
  {
    auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(input);
    for (unsigned int i = 0; collection && i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      vtkPartitionedDataSet* member = collection->GetPartitionedDataSet(i);
      for (unsigned int k = 0; member && k < member->GetNumberOfPartitions(); ++k)
      {
        this->MemberOf[member->GetPartitionAsDataObject(k)] = static_cast<int>(i);
      }
    }
  }

  int Of(vtkDataObject* block)
  {
    if (this->IsOneMesh)
    {
      return 0;
    }
    const auto found = this->MemberOf.find(block);
    return found != this->MemberOf.end() ? found->second : this->Next++;
  }

private:
  bool IsOneMesh;
  std::map<vtkDataObject*, int> MemberOf;
  int Next = 0;
};

/// The attributes of one block, from some tuple on.
struct Attributes
{
  vtkDataSetAttributes* Arrays;
  vtkIdType First;
  vtkIdType Count;
};

/// Whether an array of that name and kind is among the attributes of every block.
bool HaveAll(const std::vector<Attributes>& blocks, vtkDataArray* wanted)
{
  return wanted != nullptr && wanted->GetName() != nullptr &&
    std::all_of(blocks.begin(), blocks.end(),
      [wanted](const Attributes& block)
      {
        vtkDataArray* own = block.Arrays->GetArray(wanted->GetName());
        return own != nullptr && own->GetDataType() == wanted->GetDataType() &&
          own->GetNumberOfComponents() == wanted->GetNumberOfComponents();
      });
}

/// Copies the arrays that all blocks have, one block after the other.
void AppendArrays(const std::vector<Attributes>& blocks, vtkDataSetAttributes* whole)
{
  for (int a = 0; a < blocks.front().Arrays->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* first = blocks.front().Arrays->GetArray(a);
    if (!HaveAll(blocks, first))
    {
      continue;
    }
    const auto all = vtk::TakeSmartPointer(first->NewInstance());
    all->SetName(first->GetName());
    all->SetNumberOfComponents(first->GetNumberOfComponents());
    for (const Attributes& block : blocks)
    {
      all->InsertTuples(all->GetNumberOfTuples(), block.Count, block.First,
        block.Arrays->GetArray(first->GetName()));
    }
    whole->AddArray(all);
  }
}

/// A stretch of an array.
vtkSmartPointer<vtkDataArray> Slice(vtkDataArray* values, vtkIdType first, vtkIdType count)
{
  auto slice = vtk::TakeSmartPointer(values->NewInstance());
  slice->SetName(values->GetName());
  slice->SetNumberOfComponents(values->GetNumberOfComponents());
  slice->SetNumberOfTuples(count);
  if (count > 0)
  {
    slice->InsertTuples(0, count, first, values);
  }
  return slice;
}
}

std::string Blocks::Join(vtkCompositeDataSet* input)
{
  State state;
  ForEachBlock(input,
    [&](vtkCompositeDataIterator* at)
    {
      vtkDataObject* block = at->GetCurrentDataObject();
      state.emplace_back(block, block->GetMTime());
    });
  if (state == this->Seen)
  {
    return {};
  }
  this->Seen.clear();
  this->Members.clear();
  std::vector<int> numbers;
  Numbering numbering(input);
  std::string problem;
  ForEachBlock(input,
    [&](vtkCompositeDataIterator* at)
    {
      auto* mesh = vtkPolyData::SafeDownCast(at->GetCurrentDataObject());
      if (mesh == nullptr || !problem.empty())
      {
        return;
      }
      auto triangles = vtkSmartPointer<vtkPolyData>::New();
      Surface onlyChecked;
      problem = ReadTriangles(mesh, triangles, onlyChecked);
      problem = problem.empty()
        ? problem
        : "block " + std::to_string(at->GetCurrentFlatIndex()) + ": " + problem;
      this->Members.push_back({ triangles, 0 });
      numbers.push_back(numbering.Of(mesh));
    });
  if (problem.empty())
  {
    this->AppendBlocks(numbers);
    this->Seen = state;
  }
  return problem;
}

void Blocks::AppendBlocks(const std::vector<int>& numbers)
{
  this->Joined = vtkSmartPointer<vtkPolyData>::New();
  if (this->Members.empty())
  {
    return;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> blockOf;
  blockOf->SetName(BlockArray);
  const bool allSingle = std::all_of(this->Members.begin(), this->Members.end(),
    [](const Block& block)
    {
      vtkPoints* own = block.Triangles->GetPoints();
      return own == nullptr || own->GetDataType() == VTK_FLOAT;
    });
  points->SetDataType(allSingle ? VTK_FLOAT : VTK_DOUBLE);
  std::vector<Attributes> ofPoints, ofCells;
  for (std::size_t i = 0; i < this->Members.size(); ++i)
  {
    Block& block = this->Members[i];
    vtkPolyData* mesh = block.Triangles;
    block.FirstPoint = points->GetNumberOfPoints();
    for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
    {
      points->InsertNextPoint(mesh->GetPoint(v));
    }
    cells->Append(mesh->GetPolys(), block.FirstPoint);
    while (blockOf->GetNumberOfValues() < cells->GetNumberOfCells())
    {
      blockOf->InsertNextValue(numbers[i]);
    }
    ofPoints.push_back({ mesh->GetPointData(), 0, mesh->GetNumberOfPoints() });
    ofCells.push_back({ mesh->GetCellData(), mesh->GetNumberOfVerts() + mesh->GetNumberOfLines(),
      mesh->GetNumberOfPolys() });
  }
  this->Joined->SetPoints(points);
  this->Joined->SetPolys(cells);
  AppendArrays(ofPoints, this->Joined->GetPointData());
  AppendArrays(ofCells, this->Joined->GetCellData());
  this->Joined->GetCellData()->AddArray(blockOf);
}

void Blocks::PartOne(vtkPolyData* whole, const Block& from, vtkPolyData* mesh) const
{
  mesh->ShallowCopy(from.Triangles);
  const vtkIdType count = mesh->GetNumberOfPoints();
  if (whole->GetPoints() != this->Joined->GetPoints() && count > 0)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh->GetPoints()->GetDataType());
    points->SetNumberOfPoints(count);
    for (vtkIdType v = 0; v < count; ++v)
    {
      points->SetPoint(v, whole->GetPoint(from.FirstPoint + v));
    }
    mesh->SetPoints(points);
    mesh->GetPointData()->SetActiveNormals(nullptr); // as they do not fit any more
    mesh->GetCellData()->SetActiveNormals(nullptr);
  }
  vtkPointData* before = this->Joined->GetPointData();
  for (int a = 0; a < whole->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* values = whole->GetPointData()->GetArray(a);
    if (values != nullptr && values != before->GetArray(values->GetName()))
    {
      mesh->GetPointData()->AddArray(Slice(values, from.FirstPoint, count));
    }
  }
  if (vtkDataArray* active = whole->GetPointData()->GetScalars())
  {
    mesh->GetPointData()->SetActiveScalars(active->GetName());
  }
  for (int a = 0; a < whole->GetFieldData()->GetNumberOfArrays(); ++a)
  {
    mesh->GetFieldData()->AddArray(whole->GetFieldData()->GetAbstractArray(a));
  }
}

void Blocks::Part(vtkCompositeDataSet* input, vtkPolyData* whole, vtkCompositeDataSet* output) const
{
  output->CopyStructure(input);
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  auto member = this->Members.begin();
  ForEachBlock(input,
    [&](vtkCompositeDataIterator* at)
    {
      vtkDataObject* block = at->GetCurrentDataObject();
      const auto result = vtk::TakeSmartPointer(block->NewInstance());
      result->ShallowCopy(block);
      output->SetDataSet(at, result);
      auto* mesh = vtkPolyData::SafeDownCast(result);
      if (mesh != nullptr)
      {
        this->PartOne(whole, *member++, mesh);
      }
    });
}
}
