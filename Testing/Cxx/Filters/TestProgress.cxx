// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkCallbackCommand.h>

using namespace arris::testing;

namespace
{
/// Listens to a filter's progress, and aborts it at the report of that number (from 1; 0 never).
class Progress
{
public:
  explicit Progress(vtkAlgorithm* filter)
  {
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(this);
    listener->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void* fraction)
      {
        auto* self = static_cast<Progress*>(client);
        self->Reports.push_back(*static_cast<double*>(fraction));
        if (self->Reports.size() == self->AbortAt)
        {
          vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
        }
      });
    filter->AddObserver(vtkCommand::ProgressEvent, listener);
  }
  std::size_t AbortAt = 0;
  std::vector<double> Reports;
};
}

class ProgressOf : public EachFilter
{
};

TEST_P(ProgressOf, RisesFromZeroToOne)
{
  Progress progress(this->Filter);
  Execute(this->Filter, ReadyMesh(40));
  ASSERT_GE(progress.Reports.size(), 2u);
  EXPECT_EQ(progress.Reports.front(), 0.0);
  EXPECT_EQ(progress.Reports.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(progress.Reports.begin(), progress.Reports.end()));
}

TEST_P(ProgressOf, AnAbortLeavesNothingAndTheNextRunIsWhole)
{
  const auto input = ReadyMesh();
  const auto expected = Execute(GetParam().New(), input);

  Progress progress(this->Filter);
  Execute(this->Filter, input);
  // VTK itself reports the end: once it is done there is nothing to abort.
  const std::size_t reports = progress.Reports.size() - 1;
  ASSERT_GE(reports, 1u);
  for (std::size_t at = 1; at <= reports; ++at)
  {
    progress.Reports.clear();
    progress.AbortAt = at;
    input->Modified(); // so that nothing is kept from the run before
    this->Filter->Update();
    ExpectEmptyOutputs(this->Filter);
    EXPECT_LE(progress.Reports.size(), at + 1) << "went on after the abort at report " << at;
  }
  progress.AbortAt = 0;
  this->Filter->Modified();
  ExpectIdentical(Execute(this->Filter, input), expected);
}

INSTANTIATE_TEST_SUITE_P(Filters, ProgressOf, AllFilters(), FilterName);
