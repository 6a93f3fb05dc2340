// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

// A sphere has no sharp edge, so nothing may move; the contour of a sampled box has twelve.

#include <vtkSharpEdgeExtractor.h>
#include <vtkSharpEdgeReconstruction.h>
#include <vtkSharpThinningFilter.h>
#include <vtkSharpeningFilter.h>
#include <vtkUSSODFilter.h>

#include <vtkBox.h>
#include <vtkContourFilter.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSampleFunction.h>
#include <vtkSphereSource.h>

#include <cstdlib>
#include <iostream>

namespace
{
bool Check(bool holds, const char* what)
{
  std::cout << (holds ? "ok: " : "WRONG: ") << what << '\n';
  return holds;
}

double LargestDisplacement(vtkAlgorithm* source)
{
  vtkNew<vtkSharpEdgeReconstruction> recovery;
  recovery->SetInputConnection(source->GetOutputPort());
  recovery->Update();
  vtkDataArray* moved = recovery->GetOutput()->GetPointData()->GetArray("Displacement");
  return moved ? moved->GetMaxNorm() : -1.0;
}
}

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);

  vtkNew<vtkBox> box;
  box->SetBounds(-0.71, 0.71, -0.62, 0.62, -0.53, 0.53);
  vtkNew<vtkSampleFunction> samples;
  samples->SetImplicitFunction(box);
  samples->SetModelBounds(-1, 1, -1, 1, -1, 1);
  samples->SetSampleDimensions(24, 24, 24);
  samples->ComputeNormalsOff();
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(samples->GetOutputPort());
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();

  bool good = Check(LargestDisplacement(sphere) == 0.0, "a sphere stays as it is");
  good &= Check(LargestDisplacement(contour) > 0.01, "the edges of a box move");

  // The four steps one by one.
  vtkNew<vtkUSSODFilter> ussod;
  ussod->SetInputConnection(contour->GetOutputPort());
  vtkNew<vtkSharpThinningFilter> thinning;
  thinning->SetInputConnection(ussod->GetOutputPort());
  vtkNew<vtkSharpeningFilter> sharpening;
  sharpening->SetInputConnection(thinning->GetOutputPort());
  vtkNew<vtkSharpEdgeExtractor> edges;
  edges->SetInputConnection(sharpening->GetOutputPort());
  edges->Update();
  good &= Check(ussod->GetKappa() > 0.0, "the threshold is known");
  good &= Check(thinning->GetSkeleton()->GetNumberOfLines() > 0, "there is a skeleton");
  good &= Check(edges->GetOutput()->GetNumberOfLines() >= 12, "there are twelve edges or more");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
