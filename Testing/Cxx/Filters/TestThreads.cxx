// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkSMPTools.h>

#include <thread>

using namespace arris::testing;

// The promise: the same bytes for any number of threads and any backend.

namespace
{
struct Threading
{
  const char* Backend;
  int Threads;
};
std::ostream& operator<<(std::ostream& os, const Threading& threading)
{
  return os << threading.Backend << threading.Threads;
}

std::vector<vtkSmartPointer<vtkPolyData>> AllOutputs(vtkPolyData* input)
{
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  const auto add = [&](vtkPolyDataAlgorithm* filter)
  {
    Execute(filter, input);
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      if (filter->GetOutput(port) != nullptr)
      {
        outputs.push_back(Copy(filter->GetOutput(port)));
        continue;
      }
      // A table: its columns of numbers as field data.
      const auto rows = vtkSmartPointer<vtkPolyData>::New();
      vtkFieldData* columns = filter->GetOutputDataObject(port)->GetAttributes(vtkDataObject::ROW);
      for (int i = 0; i < columns->GetNumberOfArrays(); ++i)
      {
        if (columns->GetArray(i) != nullptr)
        {
          rows->GetFieldData()->AddArray(columns->GetArray(i));
        }
      }
      vtkNew<vtkPoints> one;
      one->InsertNextPoint(0.0, 0.0, 0.0);
      rows->SetPoints(one);
      outputs.push_back(rows);
    }
  };
  for (const int search : { vtkUSSODFilter::CONNECTED, vtkUSSODFilter::SPATIAL })
  {
    vtkNew<vtkUSSODFilter> classify;
    classify->SetWindowSearch(search);
    add(classify);
  }
  for (const int method : { vtkSharpEdgeReconstruction::PAPER, vtkSharpEdgeReconstruction::ROBUST })
  {
    vtkNew<vtkSharpEdgeReconstruction> recover;
    recover->SetMethod(method);
    add(recover);
  }
  add(vtkNew<vtkSharpThinningFilter>());
  add(vtkNew<vtkSharpeningFilter>());
  add(vtkNew<vtkSharpEdgeExtractor>());
  return outputs;
}
}

class Threads : public ::testing::TestWithParam<Threading>
{
};

TEST_P(Threads, ChangeNotASingleByte)
{
  if (!vtkSMPTools::SetBackend(GetParam().Backend))
  {
    GTEST_SKIP() << "this VTK was built without " << GetParam().Backend;
  }
  vtkSMPTools::SetBackend("Sequential");
  const auto input = ReadyMesh(48); // some thousand points: several stretches a thread
  const auto expected = AllOutputs(input);

  ASSERT_TRUE(vtkSMPTools::SetBackend(GetParam().Backend));
  vtkSMPTools::Initialize(GetParam().Threads);
  // Backends may cut the number down to that of the processors.
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  ASSERT_GE(vtkSMPTools::GetEstimatedNumberOfThreads(), std::min(processors, GetParam().Threads));
  ASSERT_LE(vtkSMPTools::GetEstimatedNumberOfThreads(), GetParam().Threads);
  for (int repetition = 0; repetition < 3; ++repetition) // threads race differently each time
  {
    const auto actual = AllOutputs(input);
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i)
    {
      ASSERT_GT(actual[i]->GetNumberOfPoints(), 0) << "output " << i;
      ExpectIdentical(actual[i], expected[i]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, Threads,
  ::testing::Values(Threading{ "Sequential", 1 }, Threading{ "STDThread", 1 },
    Threading{ "STDThread", 2 }, Threading{ "STDThread", 4 }, Threading{ "TBB", 1 },
    Threading{ "TBB", 2 }, Threading{ "TBB", 4 }),
  [](const auto& test) { return test.param.Backend + std::to_string(test.param.Threads); });
