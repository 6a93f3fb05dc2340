// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Distances.h"

#include <vtkFieldData.h>
#include <vtkMinimalStandardRandomSequence.h>

using namespace arris::testing;

namespace
{
constexpr int Samples = 48;

/// The contour of the bracket, moved by up to `size` cells along each axis.
vtkSmartPointer<vtkPolyData> NoisyBracket(double size)
{
  const vtkSmartPointer<vtkPolyData> mesh = Contour(BracketSolid(), Samples);
  vtkNew<vtkMinimalStandardRandomSequence> dice;
  dice->SetSeed(7);
  const double reach = size * CellWidth(Samples);
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    double p[3];
    mesh->GetPoint(v, p);
    for (double& x : p)
    {
      x += dice->GetNextRangeValue(-reach, reach);
    }
    mesh->GetPoints()->SetPoint(v, p);
  }
  return mesh;
}

class RoughMesh : public ::testing::Test
{
protected:
  vtkSmartPointer<vtkPolyData> Recover(bool denoise)
  {
    vtkNew<vtkSharpEdgeReconstruction> filter;
    filter->SetDenoise(denoise);
    vtkNew<ErrorCounter> warnings;
    filter->AddObserver(vtkCommand::WarningEvent, warnings);
    const vtkSmartPointer<vtkPolyData> after = Execute(filter, this->Before);
    this->Warnings = warnings->Count;
    return after;
  }

  double Found(vtkPolyData* mesh) const
  {
    const double width = CellWidth(Samples);
    return Recall(mesh, BracketSolid().SharpEdgePoints(0.05 * width), 0.2 * width);
  }

  vtkSmartPointer<vtkPolyData> Before = NoisyBracket(0.1);
  int Warnings = 0;
};
}

TEST_F(RoughMesh, IsRecognisedAndSaidSo)
{
  const auto after = this->Recover(false);
  EXPECT_EQ(after->GetFieldData()->GetArray("Roughness")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(this->Warnings, 1);
}

TEST_F(RoughMesh, KeepsItsSmoothFacesToTheBit)
{
  const auto after = this->Recover(false);
  vtkDataArray* region = after->GetPointData()->GetArray("SharpRegion");
  vtkIdType intact = 0;
  for (vtkIdType v = 0; v < after->GetNumberOfPoints(); ++v)
  {
    if (region->GetComponent(v, 0) == 0.0)
    {
      ++intact;
      double before[3], now[3];
      this->Before->GetPoint(v, before);
      after->GetPoint(v, now);
      ASSERT_TRUE(std::equal(before, before + 3, now)) << v;
    }
  }
  EXPECT_GT(intact, after->GetNumberOfPoints() / 4);
}

TEST_F(RoughMesh, GetsItsSharpEdgesBack)
{
  EXPECT_GE(this->Found(this->Recover(false)), 0.9);
}

TEST_F(RoughMesh, IsSmoothedWhereThatIsAskedFor)
{
  const auto after = this->Recover(true);
  EXPECT_GE(this->Found(after), 0.9);
  // Noise lights up everywhere; a smoothed mesh has little more than its true edges left.
  EXPECT_LT(SharpMeshEdges(after)->GetNumberOfCells(),
    SharpMeshEdges(this->Before)->GetNumberOfCells() / 3);
}

TEST(SmoothMesh, IsNotRoughAndIsNotWarnedOf)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  vtkNew<ErrorCounter> warnings;
  filter->AddObserver(vtkCommand::WarningEvent, warnings);
  const auto after = Execute(filter, Contour(BracketSolid(), Samples));
  EXPECT_EQ(after->GetFieldData()->GetArray("Roughness")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(warnings->Count, 0);
}
