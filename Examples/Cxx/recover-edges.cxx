// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

// Reads a mesh, gives it its sharp edges back, and writes it: recover-edges IN.ply OUT.ply

#include <vtkSharpEdgeReconstruction.h>

#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: recover-edges IN.ply OUT.ply\n";
    return 2;
  }

  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argv[1]);

  vtkNew<vtkSharpEdgeReconstruction> recovery;
  recovery->SetInputConnection(reader->GetOutputPort());
  recovery->Update();

  vtkPolyData* mesh = recovery->GetOutput();
  if (mesh->GetNumberOfPolys() == 0)
  {
    std::cerr << argv[1] << " gave no triangles\n";
    return EXIT_FAILURE;
  }
  vtkDataArray* region = mesh->GetPointData()->GetArray("SharpRegion");
  vtkIdType sharp = 0;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    sharp += region->GetTuple1(point) != 0.0 ? 1 : 0;
  }
  std::cout << sharp << " of " << mesh->GetNumberOfPoints() << " vertices lie at sharp edges\n";

  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(argv[2]);
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
