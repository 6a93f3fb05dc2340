// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchIds.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace arris
{
namespace
{
/// Stands for the number that a cell should have and has not.
constexpr double Missing = -1.0;

using Key = std::array<double, 2>;

vtkAbstractArray* FindArray(vtkPolyData* mesh, const std::string& name)
{
  vtkCellData* cellData = mesh->GetCellData();
  vtkAbstractArray* array = cellData->GetAbstractArray(name.c_str());
  if (array != nullptr || name != DefaultPatchArray)
  {
    return array;
  }
  vtkDataArray* labels = cellData->GetArray(BoundaryLabelsArray);
  return labels != nullptr && labels->GetNumberOfComponents() == 2 ? labels : nullptr;
}

std::string ProblemWithArray(vtkAbstractArray* array, const std::string& title, vtkIdType cellCount)
{
  if (vtkDataArray::SafeDownCast(array) == nullptr)
  {
    return title + " does not hold numbers";
  }
  if (array->GetNumberOfComponents() > 2)
  {
    return title + " has " + std::to_string(array->GetNumberOfComponents()) +
      " components; a patch is told by one number, or by the two of the materials beside it";
  }
  if (array->GetNumberOfTuples() != cellCount)
  {
    return title + " has " + std::to_string(array->GetNumberOfTuples()) + " entries for " +
      std::to_string(cellCount) + " cells";
  }
  return {};
}

/// The numbers of a cell; false if they are not whole.
bool ReadKey(vtkDataArray* array, vtkIdType cell, Key& key)
{
  const int components = array->GetNumberOfComponents();
  key = { 0.0, 0.0 };
  for (int c = 0; c < components; ++c)
  {
    const double value = array->GetComponent(cell, c);
    key[c] = std::isnan(value) ? Missing : value;
    if (key[c] != std::floor(key[c]) || std::isinf(key[c]))
    {
      return false;
    }
  }
  if (components == 1)
  {
    key[0] = std::max(key[0], Missing);
  }
  else if (key[0] > key[1])
  {
    std::swap(key[0], key[1]); // materials may stand on either side
  }
  return true;
}
}

std::string ReadPatchIds(
  vtkPolyData* mesh, const std::string& name, const Surface& surface, std::vector<Index>& ids)
{
  ids.clear();
  if (name.empty())
  {
    return {};
  }
  vtkAbstractArray* found = FindArray(mesh, name);
  if (found == nullptr)
  {
    return name == DefaultPatchArray ? std::string()
                                     : "there is no cell array '" + name + "' to tell patches by";
  }
  const std::string title = "the cell array '" + std::string(found->GetName()) + "'";
  std::string problem = ProblemWithArray(found, title, mesh->GetNumberOfCells());
  if (!problem.empty())
  {
    return problem;
  }
  vtkDataArray* array = vtkDataArray::SafeDownCast(found);
  std::map<Key, Index> idOf;
  for (Index t = 0; t < surface.Triangulation.TriangleCount(); ++t)
  {
    const vtkIdType cell = surface.CellOf(t);
    Key key;
    if (!ReadKey(array, cell, key))
    {
      return title + " has a number that is not whole at cell " + std::to_string(cell);
    }
    ids.push_back(idOf.emplace(key, static_cast<Index>(idOf.size())).first->second);
  }
  return {};
}
}
