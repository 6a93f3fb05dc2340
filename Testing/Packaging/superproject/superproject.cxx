// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

// All eight vertices of a cube are sharp, and none of a sphere.

#include <vtkSharpVertexCounter.h>

#include <vtkNew.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkPlatonicSolidSource> cube;
  cube->SetSolidTypeToCube();
  cube->Update();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  sphere->Update();

  vtkNew<vtkSharpVertexCounter> counter;
  const vtkIdType onCube = counter->Count(cube->GetOutput());
  const vtkIdType onSphere = counter->Count(sphere->GetOutput());
  std::cout << "sharp vertices: cube " << onCube << ", sphere " << onSphere << '\n';
  return onCube == 8 && onSphere == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
