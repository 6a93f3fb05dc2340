// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FilterTesting.h
/// Runs filters and looks at what they say and give.

#ifndef arris_testing_FilterTesting_h
#define arris_testing_FilterTesting_h

#include "Solids.h"

#include "vtkSharpEdgeExtractor.h"
#include "vtkSharpEdgePreview.h"
#include "vtkSharpEdgeReconstruction.h"
#include "vtkSharpThinningFilter.h"
#include "vtkSharpeningFilter.h"
#include "vtkUSSODFilter.h"

#include <gtest/gtest.h>

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <ostream>

namespace arris
{
namespace testing
{
/// Counts the errors of a filter and of its executive, and keeps them from the screen.
class ErrorCounter : public vtkCommand
{
public:
  static ErrorCounter* New() { return new ErrorCounter; }
  void Execute(vtkObject*, unsigned long, void* text) override
  {
    ++this->Count;
    this->Text = static_cast<const char*>(text);
  }
  void Watch(vtkAlgorithm* filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
  }
  int Count = 0;
  std::string Text;
};

/// One of the public filters, to run a test on all of them.
struct FilterKind
{
  const char* Name;
  vtkSmartPointer<vtkPolyDataAlgorithm> (*New)();
};
inline std::ostream& operator<<(std::ostream& os, const FilterKind& kind)
{
  return os << kind.Name;
}
template <typename Filter>
FilterKind Kind(const char* name)
{
  return { name,
    [] { return vtkSmartPointer<vtkPolyDataAlgorithm>(vtkSmartPointer<Filter>::New()); } };
}
inline auto AllFilters()
{
  return ::testing::Values(Kind<vtkUSSODFilter>("USSOD"), Kind<vtkSharpThinningFilter>("Thinning"),
    Kind<vtkSharpeningFilter>("Sharpening"), Kind<vtkSharpEdgeExtractor>("Extractor"),
    Kind<vtkSharpEdgeReconstruction>("Reconstruction"), Kind<vtkSharpEdgePreview>("Preview"));
}
/// Those that hand on a mesh, whatever it is.
inline auto FiltersOfMeshes()
{
  return ::testing::Values(Kind<vtkUSSODFilter>("USSOD"), Kind<vtkSharpThinningFilter>("Thinning"),
    Kind<vtkSharpeningFilter>("Sharpening"), Kind<vtkSharpEdgeReconstruction>("Reconstruction"),
    Kind<vtkSharpEdgePreview>("Preview"));
}
inline std::string FilterName(const ::testing::TestParamInfo<FilterKind>& test)
{
  return test.param.Name;
}
class EachFilter : public ::testing::TestWithParam<FilterKind>
{
protected:
  vtkSmartPointer<vtkPolyDataAlgorithm> Filter = GetParam().New();

  /// The output that is the input's mesh and more: the last one of the extractor.
  vtkPolyData* MeshOutput()
  {
    return this->Filter->GetOutput(std::string(GetParam().Name) == "Extractor" ? 2 : 0);
  }
};

inline vtkSmartPointer<vtkPolyData> Copy(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

inline vtkSmartPointer<vtkPolyData> Execute(vtkPolyDataAlgorithm* filter, vtkPolyData* input)
{
  filter->SetInputData(input);
  filter->Update();
  return Copy(filter->GetOutput());
}

inline vtkSmartPointer<vtkPolyData> RecoverByPaper(vtkPolyData* input)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetMethodToPaper();
  return Execute(filter, input);
}

/// A contour of the L-bracket with the arrays that any of the filters may need.
inline vtkSmartPointer<vtkPolyData> ReadyMesh(int samples = 24)
{
  vtkSmartPointer<vtkPolyData> mesh = Contour(BracketSolid(), samples);
  const vtkSmartPointer<vtkPolyData> recovered = RecoverByPaper(mesh);
  for (const char* name : { "SharpRegion", "USSOD", "ThinningRound" })
  {
    mesh->GetPointData()->AddArray(recovered->GetPointData()->GetArray(name));
  }
  return mesh;
}

/// A point array of one value, such as ThinningRound, from a function of the point's number.
template <typename ArrayType, typename ValueAt>
void AddArray(vtkFieldData* attributes, vtkIdType count, const char* name, ValueAt&& valueAt)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetValue(i, valueAt(i));
  }
  attributes->AddArray(array);
}

/// The arrays of the region for a mesh that has none: so the filters run, and move nothing.
inline void AddQuietArrays(vtkPolyData* mesh)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  AddArray<vtkUnsignedCharArray>(
    mesh->GetPointData(), count, "SharpRegion", [](vtkIdType) { return 0; });
  AddArray<vtkIntArray>(mesh->GetPointData(), count, "ThinningRound", [](vtkIdType) { return -1; });
}

inline bool SameBytes(vtkDataArray* a, vtkDataArray* b)
{
  return a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples() &&
    (a->GetNumberOfValues() == 0 ||
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
        static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0);
}

inline bool IsTiming(const std::string& name)
{
  const std::string ending = "Seconds";
  return name.size() >= ending.size() &&
    name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

inline void ExpectSameArrays(vtkFieldData* a, vtkFieldData* b, const std::string& where)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays()) << where;
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    const std::string name = a->GetArrayName(i);
    vtkDataArray* other = b->GetArray(name.c_str());
    ASSERT_NE(other, nullptr) << where << ' ' << name;
    EXPECT_TRUE(IsTiming(name) || SameBytes(a->GetArray(i), other)) << where << ' ' << name;
  }
}

inline void ExpectSameCells(vtkCellArray* a, vtkCellArray* b, const char* kind)
{
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells()) << kind;
  vtkNew<vtkIdList> idsA;
  vtkNew<vtkIdList> idsB;
  for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
  {
    a->GetCellAtId(i, idsA);
    b->GetCellAtId(i, idsB);
    ASSERT_TRUE(std::equal(idsA->begin(), idsA->end(), idsB->begin(), idsB->end()))
      << kind << ' ' << i;
  }
}

/// All of two meshes to the last bit, but for how long something took.
inline void ExpectIdentical(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  if (a->GetNumberOfPoints() > 0)
  {
    EXPECT_TRUE(SameBytes(a->GetPoints()->GetData(), b->GetPoints()->GetData())) << "points";
  }
  ExpectSameCells(a->GetVerts(), b->GetVerts(), "vertices");
  ExpectSameCells(a->GetLines(), b->GetLines(), "lines");
  ExpectSameCells(a->GetPolys(), b->GetPolys(), "polygons");
  ExpectSameCells(a->GetStrips(), b->GetStrips(), "strips");
  ExpectSameArrays(a->GetPointData(), b->GetPointData(), "point array");
  ExpectSameArrays(a->GetCellData(), b->GetCellData(), "cell array");
  ExpectSameArrays(a->GetFieldData(), b->GetFieldData(), "field array");
}

inline void ExpectEmptyOutputs(vtkPolyDataAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* output = filter->GetOutput(port);
    if (output == nullptr) // a table
    {
      EXPECT_EQ(filter->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::ROW), 0);
      continue;
    }
    EXPECT_EQ(output->GetNumberOfPoints(), 0) << "port " << port;
    EXPECT_EQ(output->GetNumberOfCells(), 0) << "port " << port;
    EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0) << "port " << port;
    EXPECT_EQ(output->GetCellData()->GetNumberOfArrays(), 0) << "port " << port;
  }
}

/// The filter reports one error about something, and gives nothing.
inline void ExpectOneError(
  vtkPolyDataAlgorithm* filter, vtkPolyData* input, const std::string& about)
{
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  filter->SetInputData(input);
  filter->Update();
  EXPECT_EQ(errors->Count, 1) << about;
  EXPECT_NE(errors->Text.find(about), std::string::npos) << errors->Text;
  ExpectEmptyOutputs(filter);
}
}
}

#endif
