// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// What a user sets, the robust method obeys; and it tells what it used and did.

#include "FilterTesting.h"
#include "Solids.h"

#include <vtkFieldData.h>

#include <cmath>

using namespace arris::testing;

namespace
{
vtkIdType Count(vtkPolyData* mesh, const char* name, double value)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  vtkIdType count = 0;
  for (vtkIdType v = 0; v < array->GetNumberOfTuples(); ++v)
  {
    count += array->GetComponent(v, 0) == value ? 1 : 0;
  }
  return count;
}

double Field(vtkPolyData* mesh, const char* name)
{
  return mesh->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}
}

TEST(SetParameters, AnEdgeBelowTheAngleIsLeftAlone)
{
  const auto box = Contour(BoxSolid(), 32);
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetSharpAngle(80.0);
  const auto all = Execute(filter, box);
  EXPECT_GT(Count(all, "SharpRegion", 1.0), 0);
  EXPECT_EQ(Field(all, "SharpAngle"), 80.0);
  filter->SetSharpAngle(130.0); // the box's edges turn by 90, its corners by up to 120
  EXPECT_EQ(Count(Execute(filter, box), "SharpRegion", 1.0), 0);
}

TEST(SetParameters, TheWindowIsTheSameEverywhere)
{
  const auto box = Contour(BoxSolid(), 32);
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetWindow(0.9 * CellWidth(32));
  const auto after = Execute(filter, box);
  double range[2];
  after->GetPointData()->GetArray("Window")->GetRange(range);
  EXPECT_DOUBLE_EQ(range[0], 0.9 * CellWidth(32));
  EXPECT_DOUBLE_EQ(range[1], 0.9 * CellWidth(32));
  EXPECT_DOUBLE_EQ(Field(after, "Lambda"), 0.9 * CellWidth(32));
}

TEST(SetParameters, TheRatioIsOfTheAverageEdge)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetWindowRatio(1.25);
  const auto after = Execute(filter, Contour(BoxSolid(), 32));
  EXPECT_DOUBLE_EQ(Field(after, "Lambda"), 1.25 * Field(after, "AverageEdgeLength"));
}

TEST(Account, OfEveryVertexAgreesWithWhatWasDone)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  const auto after = Execute(filter, Contour(BracketSolid(), 48));
  vtkPointData* data = after->GetPointData();
  enum Outcome // the numbers that the class documents
  {
    Intact = 0,
    Moved = 1,
    Right = 2
  };
  for (vtkIdType v = 0; v < after->GetNumberOfPoints(); ++v)
  {
    const double* step = data->GetArray("Displacement")->GetTuple3(v);
    const bool moved = std::hypot(step[0], step[1], step[2]) > 0.0;
    const auto outcome = static_cast<int>(data->GetArray("Outcome")->GetComponent(v, 0));
    const bool damaged = data->GetArray("SharpRegion")->GetComponent(v, 0) != 0.0;
    ASSERT_EQ(outcome == Intact, !damaged) << v;
    ASSERT_LE(outcome, 5) << v;
    if (outcome == Intact || outcome == Right)
    {
      ASSERT_FALSE(moved) << v;
    }
  }
  EXPECT_GT(Count(after, "Outcome", Moved), after->GetNumberOfPoints() / 20);
  // The bracket's edges are all right angles; corners turn otherwise.
  double range[2];
  data->GetArray("EdgeAngle")->GetRange(range);
  EXPECT_GT(range[1], 85.0);
}
