// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Segments.h
/// The segments that polylines are made of.

#ifndef arris_Segments_h
#define arris_Segments_h

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace arris
{
/// Calls visit(from, to) with the point ids of each segment of the lines, in their order.
template <typename Visit>
void ForEachSegment(vtkPolyData* lines, Visit&& visit)
{
  const auto line = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    line->GetCurrentCell(count, ids);
    for (vtkIdType i = 0; i + 1 < count; ++i)
    {
      visit(ids[i], ids[i + 1]);
    }
  }
}
}

#endif
