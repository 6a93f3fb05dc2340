// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

using namespace arris::testing;

namespace
{
/// The three stages one after the other, with the same parameters.
struct Chain
{
  vtkNew<vtkUSSODFilter> Classify;
  vtkNew<vtkSharpThinningFilter> Thin;
  vtkNew<vtkSharpeningFilter> Sharpen;

  explicit Chain(vtkPolyData* input)
  {
    this->Classify->SetInputData(input);
    this->Thin->SetInputConnection(this->Classify->GetOutputPort());
    this->Sharpen->SetInputConnection(this->Thin->GetOutputPort());
  }
  vtkPolyData* Output()
  {
    this->Sharpen->Update();
    return this->Sharpen->GetOutput();
  }
};
}

TEST(Chaining, GivesTheSameAsAllInOne)
{
  for (const Solid& solid : { BoxSolid(), CylinderSolid(), BracketSolid() })
  {
    const auto mesh = Contour(solid, 32);
    ExpectIdentical(Chain(mesh).Output(), RecoverByPaper(mesh));
  }
}

TEST(Chaining, GivesTheSameWithOtherParameters)
{
  const auto mesh = Contour(BracketSolid(), 32);
  Chain chain(mesh);
  chain.Classify->SetWindowRatio(1.1); // the sharpening filter takes λ from the field data
  chain.Classify->SetSharpAngle(55.0);
  chain.Classify->SetWindowSearchToSpatial();
  vtkNew<vtkSharpEdgeReconstruction> whole;
  whole->SetMethodToPaper();
  whole->SetWindowRatio(1.1);
  whole->SetSharpAngle(55.0);
  whole->SetWindowSearchToSpatial();
  ExpectIdentical(chain.Output(), Execute(whole, mesh));
}

TEST(Chaining, TheSharpeningFilterPrefersAWindowOfItsOwn)
{
  const auto mesh = Contour(BracketSolid(), 32);
  Chain chain(mesh);
  const auto usual = Copy(chain.Output());
  chain.Sharpen->SetWindow(3.0 * CellWidth(32));
  EXPECT_FALSE(SameBytes(chain.Output()->GetPoints()->GetData(), usual->GetPoints()->GetData()));
}

TEST(Chaining, ThinningTakesAnyArrayAsTheRegion)
{
  const auto mesh = ReadyMesh();
  vtkNew<vtkSharpThinningFilter> usual;
  const auto expected = Execute(usual, mesh);
  vtkDataArray* region = mesh->GetPointData()->GetArray("SharpRegion");
  AddArray<vtkDoubleArray>(mesh->GetPointData(), mesh->GetNumberOfPoints(), "MyRegion",
    [&](vtkIdType v) { return 2.5 * region->GetComponent(v, 0); }); // anything but 0 is in it
  mesh->GetPointData()->RemoveArray("SharpRegion");
  vtkNew<vtkSharpThinningFilter> filter;
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "MyRegion");
  EXPECT_TRUE(SameBytes(Execute(filter, mesh)->GetPointData()->GetArray("ThinningRound"),
    expected->GetPointData()->GetArray("ThinningRound")));
}
