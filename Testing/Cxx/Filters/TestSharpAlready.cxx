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

#include <array>
#include <vector>

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

/// The thread of a screw as CAD tessellates it, open at both ends: long facets between helices. The
/// profile has a radius and a height for each; a turn rises by one.
vtkSmartPointer<vtkPolyData> Thread(const std::vector<std::array<double, 2>>& profile, int steps)
{
  constexpr int Turns = 8;
  const auto across = static_cast<vtkIdType>(profile.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType step = 0; step <= Turns * steps; ++step)
  {
    const double turn = static_cast<double>(step) / steps;
    const double angle = 2.0 * vtkMath::Pi() * turn;
    for (vtkIdType k = 0; k < across; ++k)
    {
      const vtkIdType next = points->InsertNextPoint(
        profile[k][0] * std::cos(angle), profile[k][0] * std::sin(angle), profile[k][1] + turn);
      if (step > 0 && k > 0)
      {
        const vtkIdType lower[3] = { next - across - 1, next - 1, next - across };
        const vtkIdType upper[3] = { next - 1, next, next - across };
        triangles->InsertNextCell(3, lower);
        triangles->InsertNextCell(3, upper);
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
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

TEST(SharpAlready, OpenThreadsComeBackAsTheyAre)
{
  // Away from each other, so that their free boundaries are not sewn to each other. The blunt one's
  // facets are two edges wide; with more steps a turn they would be too long for that.
  const std::vector<std::array<double, 2>> pointed{ { 4.0, -0.4 }, { 5.0, 0.0 }, { 4.0, 0.4 } };
  const std::vector<std::array<double, 2>> blunt{ { 4.0, -0.4 }, { 5.0, -0.2 }, { 5.0, 0.2 },
    { 4.0, 0.4 } };
  for (const auto& profile : { pointed, blunt })
  {
    for (const int steps : { 12, 16, 20 })
    {
      vtkNew<vtkSharpEdgeReconstruction> recovery;
      const auto mesh = Thread(profile, steps);
      const auto after = Execute(recovery, mesh);
      EXPECT_TRUE(SameBytes(after->GetPoints()->GetData(), mesh->GetPoints()->GetData()))
        << steps << " steps a turn";
    }
  }
}
