// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Contour.h"

#include "ErrorCapture.h"
#include "Failure.h"
#include "ProgressBar.h"
#include "Text.h"

#include <vtkDataArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>

namespace arris
{
namespace
{
/// Whether more samples on the border of the volume are above the value than not. There is the
/// outside: a closed surface within the volume has its whole border on the outer side.
bool OutsideIsAbove(vtkImageData* volume, double value)
{
  vtkDataArray* values = volume->GetPointData()->GetScalars();
  int size[3];
  volume->GetDimensions(size);
  vtkIdType above = 0;
  vtkIdType samples = 0;
  vtkIdType id = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      const bool inBorderRow = j == 0 || j + 1 == size[1] || k == 0 || k + 1 == size[2];
      const int step = inBorderRow ? 1 : size[0] - 1;
      for (int i = 0; i < size[0]; i += step)
      {
        above += values->GetComponent(id + i, 0) >= value ? 1 : 0;
        ++samples;
      }
      id += size[0];
    }
  }
  return 2 * above > samples;
}

vtkSmartPointer<vtkPolyData> Reversed(vtkPolyData* mesh)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(mesh);
  reverse->ReverseCellsOn();
  reverse->ReverseNormalsOff();
  reverse->Update();
  return reverse->GetOutput();
}
}

vtkSmartPointer<vtkPolyData> Contour(
  vtkImageData* volume, double value, Inside inside, const std::string& name, ProgressBar& progress)
{
  const ErrorCapture capture;
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(volume);
  contour->SetValue(0, value);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->SetArrayComponent(0);
  progress.Follow("contouring", contour);
  contour->Update();
  progress.Clear();
  const std::string cause = capture.FirstError();
  if (!cause.empty())
  {
    throw Failure(name, "cannot be contoured: " + cause, "give another volume");
  }
  const vtkSmartPointer<vtkPolyData> surface = contour->GetOutput();
  if (surface->GetNumberOfPolys() == 0)
  {
    double range[2];
    volume->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
    throw Failure(name, "has no surface at the value " + Number(value, 6),
      "give a --value between " + Number(range[0], 6) + " and " + Number(range[1], 6));
  }
  // vtkFlyingEdges3D makes triangles face to where the values are lower.
  const bool outsideIsAbove =
    inside == Inside::Auto ? OutsideIsAbove(volume, value) : inside == Inside::Below;
  return outsideIsAbove ? Reversed(surface) : surface;
}
}
