// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Distances.h"

#include <vtkFieldData.h>
#include <vtkQuadricDecimation.h>

using namespace arris::testing;

// What decimation leaves of a blurred box: large triangles in its faces, small ones where it is
// round, as in scans of castings and in tessellations.

namespace
{
constexpr int Samples = 32;
constexpr double BlurWidth = 0.8; // in cells
constexpr double Removed = 0.5;

class MeantBends : public ::testing::Test
{
protected:
  static vtkSmartPointer<vtkPolyData> Sampled()
  {
    return BlurredContour(BoxSolid(), Samples, BlurWidth);
  }

  static vtkSmartPointer<vtkPolyData> WithFinerBends()
  {
    vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputData(Sampled());
    decimation->SetTargetReduction(Removed);
    decimation->Update();
    return decimation->GetOutput();
  }

  vtkSmartPointer<vtkPolyData> Recover(vtkPolyData* mesh)
  {
    vtkNew<ErrorCounter> warnings;
    this->Filter->AddObserver(vtkCommand::WarningEvent, warnings);
    const auto recovered = Execute(this->Filter, mesh);
    this->Warnings = warnings->Count;
    return recovered;
  }

  static double Field(vtkPolyData* mesh, const char* name)
  {
    return mesh->GetFieldData()->GetArray(name)->GetComponent(0, 0);
  }

  static vtkIdType Moved(vtkPolyData* before, vtkPolyData* after)
  {
    vtkIdType moved = 0;
    for (vtkIdType p = 0; p < before->GetNumberOfPoints(); ++p)
    {
      moved += Point3(before->GetPoint(p)) != Point3(after->GetPoint(p)) ? 1 : 0;
    }
    return moved;
  }

  vtkNew<vtkSharpEdgeReconstruction> Filter;
  int Warnings = 0;
};
}

TEST_F(MeantBends, AreLeftAloneAndWarnedOf)
{
  const auto mesh = WithFinerBends();
  const auto after = this->Recover(mesh);
  EXPECT_EQ(Moved(mesh, after), 0);
  EXPECT_EQ(Field(after, "BendsAreMeant"), 1.0);
  EXPECT_LT(Field(after, "BendTriangleSize"), 0.75);
  EXPECT_EQ(this->Warnings, 1);
}

TEST_F(MeantBends, AreSharpenedWhenAnAngleIsSet)
{
  const auto mesh = WithFinerBends();
  this->Filter->SetSharpAngle(16.0);
  const auto after = this->Recover(mesh);
  EXPECT_GT(Moved(mesh, after), mesh->GetNumberOfPoints() / 10);
  EXPECT_EQ(Field(after, "BendsAreMeant"), 0.0);
}

TEST_F(MeantBends, AreNotThoseOfASampledMesh)
{
  const auto mesh = Sampled();
  const auto after = this->Recover(mesh);
  EXPECT_GT(Moved(mesh, after), 0);
  EXPECT_EQ(Field(after, "BendsAreMeant"), 0.0);
  EXPECT_GT(Field(after, "BendTriangleSize"), 0.9);
  EXPECT_EQ(this->Warnings, 0);
}
