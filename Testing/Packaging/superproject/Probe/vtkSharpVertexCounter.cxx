// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSharpVertexCounter.h"

#include "vtkUSSODFilter.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkSharpVertexCounter);

vtkIdType vtkSharpVertexCounter::Count(vtkPolyData* mesh)
{
  vtkNew<vtkUSSODFilter> ussod;
  ussod->SetInputData(mesh);
  ussod->Update();
  vtkDataArray* region = ussod->GetOutput()->GetPointData()->GetArray("SharpRegion");
  if (!region)
  {
    return -1;
  }
  vtkIdType sharp = 0;
  for (vtkIdType point = 0; point < region->GetNumberOfTuples(); ++point)
  {
    sharp += region->GetTuple1(point) != 0.0 ? 1 : 0;
  }
  return sharp;
}
