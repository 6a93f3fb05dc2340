// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

using namespace arris::testing;

class InputUntouched : public EachFilter
{
};

TEST_P(InputUntouched, ToTheLastBitAndArray)
{
  const auto input = ReadyMesh();
  AddArray<vtkDoubleArray>(input->GetFieldData(), 2, "Remark", [](vtkIdType i) { return i; });
  // Arrays of the names that the filters write, with other contents: theirs must replace these in
  // the output only.
  for (const char* name : { "USSOD", "NormalDeviation", "SkeletonRole" })
  {
    AddArray<vtkDoubleArray>(input->GetPointData(), input->GetNumberOfPoints(), name,
      [](vtkIdType i) { return static_cast<double>(i % 7); });
  }
  AddArray<vtkDoubleArray>(
    input->GetFieldData(), 1, "AverageEdgeLength", [](vtkIdType) { return 9.0; });
  const auto before = Copy(input);
  const vtkMTimeType time = input->GetMTime();
  Execute(this->Filter, input);
  ASSERT_GT(this->MeshOutput()->GetNumberOfPoints(), 0);
  ExpectIdentical(input, before);
  EXPECT_EQ(input->GetMTime(), time) << "or everything downstream of it would run again";
}

TEST_P(InputUntouched, WithStripsAndPolygons)
{
  const auto input = ReadyMesh();
  vtkNew<vtkCellArray> strips;
  const vtkIdType strip[] = { 0, 1, 2, 3 };
  strips->InsertNextCell(4, strip);
  input->SetStrips(strips);
  AddArray<vtkDoubleArray>(
    input->GetCellData(), input->GetNumberOfCells(), "Cell", [](vtkIdType i) { return i; });
  const auto before = Copy(input);
  Execute(this->Filter, input);
  ASSERT_GT(this->MeshOutput()->GetNumberOfPoints(), 0);
  ExpectIdentical(input, before);
}

INSTANTIATE_TEST_SUITE_P(Filters, InputUntouched, AllFilters(), FilterName);
