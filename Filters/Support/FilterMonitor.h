// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FilterMonitor.h
/// Ties the method's progress and abort to those of a VTK filter.

#ifndef arris_FilterMonitor_h
#define arris_FilterMonitor_h

#include "Core/Parallel.h"

#include <vtkAlgorithm.h>

#include <type_traits>

namespace arris
{
namespace detail
{
// vtkAlgorithm::CheckAbort, which also sees that a filter upstream was aborted, came after VTK 9.1.
template <typename Algorithm>
auto Aborted(Algorithm* filter, int) -> decltype(filter->CheckAbort())
{
  return filter->CheckAbort();
}
template <typename Algorithm>
bool Aborted(Algorithm* filter, long)
{
  return filter->GetAbortExecute() != 0;
}
}

/// A monitor that updates the filter's progress and stops when the filter is aborted.
inline Monitor MonitorOf(vtkAlgorithm* filter)
{
  return Monitor(
    [filter](double fraction)
    {
      filter->UpdateProgress(fraction);
      return !detail::Aborted(filter, 0);
    });
}
}

#endif
