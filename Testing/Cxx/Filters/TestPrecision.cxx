// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkFloatArray.h>

using namespace arris::testing;

namespace
{
vtkSmartPointer<vtkPolyData> InPrecision(vtkPolyData* mesh, int type)
{
  auto copy = Copy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->DeepCopy(mesh->GetPoints());
  copy->SetPoints(points);
  return copy;
}
}

class Precision : public EachFilter
{
};

TEST_P(Precision, OfThePointsStays)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto input = InPrecision(ReadyMesh(), type);
    ASSERT_EQ(input->GetPoints()->GetDataType(), type);
    this->Filter->SetInputData(input);
    this->Filter->Update();
    for (int port = 0; port < this->Filter->GetNumberOfOutputPorts(); ++port)
    {
      if (this->Filter->GetOutput(port) == nullptr)
      {
        continue; // a table
      }
      if (this->Filter->GetOutput(port)->GetCellData()->HasArray("SkeletonRole"))
      {
        continue; // the preview's marks: always double
      }
      ASSERT_GT(this->Filter->GetOutput(port)->GetNumberOfPoints(), 0) << "port " << port;
      EXPECT_EQ(this->Filter->GetOutput(port)->GetPoints()->GetDataType(), type) << "port " << port;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, Precision, AllFilters(), FilterName);

TEST(IntactVertices, KeepEveryBit)
{
  for (const int method : { vtkSharpEdgeReconstruction::PAPER, vtkSharpEdgeReconstruction::ROBUST })
  {
    for (const int type : { VTK_FLOAT, VTK_DOUBLE })
    {
      const auto input = InPrecision(Contour(BracketSolid(), 32), type);
      vtkNew<vtkSharpEdgeReconstruction> filter;
      filter->SetMethod(method);
      const auto output = Execute(filter, input);
      vtkIdType intact = 0;
      vtkIdType moved = 0;
      for (vtkIdType v = 0; v < input->GetNumberOfPoints(); ++v)
      {
        Point3 before, after;
        input->GetPoint(v, before.data());
        output->GetPoint(v, after.data());
        if (output->GetPointData()->GetArray("ThinningRound")->GetComponent(v, 0) == -1.0)
        {
          ASSERT_EQ(before, after) << "vertex " << v;
          ++intact;
        }
        else
        {
          moved += before != after ? 1 : 0;
        }
      }
      EXPECT_GT(intact, input->GetNumberOfPoints() / 2);
      EXPECT_GT(moved, 0);
    }
  }
}

TEST(IntactVertices, AMeshWithoutSharpRegionKeepsItsPoints)
{
  // A box sampled so finely that a threshold above its angles finds nothing.
  const auto input = Contour(BoxSolid(), 24);
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetMethodToPaper();
  filter->SetSharpAngle(180.0);
  const auto output = Execute(filter, input);
  EXPECT_TRUE(SameBytes(output->GetPoints()->GetData(), input->GetPoints()->GetData()));
}

TEST(Normals, ThatCameWithTheInputStayButShadeNoMore)
{
  const auto input = ReadyMesh();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(input->GetNumberOfPoints());
  normals->Fill(0.5);
  input->GetPointData()->SetNormals(normals);
  const auto output = RecoverByPaper(input);
  EXPECT_EQ(output->GetPointData()->GetNormals(), nullptr) << "they do not fit any more";
  EXPECT_NE(output->GetPointData()->GetArray("Normals"), nullptr);
  EXPECT_NE(input->GetPointData()->GetNormals(), nullptr) << "the input's still do";
}
