// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// Solids that have lost nothing come back as they went in, to the last bit.

#include "FilterTesting.h"

#include <vtkCleanPolyData.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkTriangleFilter.h>

using namespace arris::testing;

namespace
{
/// In triangles that share their points, each cut in four as many times as told.
vtkSmartPointer<vtkPolyData> Tessellated(vtkPolyDataAlgorithm* source, int subdivisions)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkLinearSubdivisionFilter> fine;
  fine->SetInputConnection(merged->GetOutputPort());
  fine->SetNumberOfSubdivisions(subdivisions);
  fine->Update();
  return fine->GetOutput();
}

void ExpectUnmoved(vtkPolyData* mesh)
{
  vtkNew<vtkSharpEdgeReconstruction> recovery;
  const auto after = Execute(recovery, mesh);
  EXPECT_GT(
    after->GetPointData()->GetArray("SharpRegion")->GetRange()[1], 0.0); // or it saw no edge
  EXPECT_TRUE(SameBytes(after->GetPoints()->GetData(), mesh->GetPoints()->GetData()));
}
}

TEST(SharpAlready, PlatonicSolidsComeBackAsTheyAre)
{
  for (const int kind : { VTK_SOLID_TETRAHEDRON, VTK_SOLID_CUBE, VTK_SOLID_OCTAHEDRON,
         VTK_SOLID_ICOSAHEDRON, VTK_SOLID_DODECAHEDRON })
  {
    vtkNew<vtkPlatonicSolidSource> solid;
    solid->SetSolidType(kind);
    const auto mesh = Tessellated(solid, 4);
    SCOPED_TRACE(kind);
    ExpectUnmoved(mesh);
  }
}

TEST(SharpAlready, BoxOfUnequalSidesComesBackAsItIs)
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(3.0);
  box->SetZLength(0.7);
  ExpectUnmoved(Tessellated(box, 4));
}

TEST(SharpAlready, CoarseCylinderComesBackAsItIs)
{
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(64);
  vtkNew<vtkSharpEdgeReconstruction> recovery;
  const auto mesh = Tessellated(cylinder, 0);
  const auto after = Execute(recovery, mesh);
  EXPECT_TRUE(SameBytes(after->GetPoints()->GetData(), mesh->GetPoints()->GetData()));
}
