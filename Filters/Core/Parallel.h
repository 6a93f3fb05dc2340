// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Parallel.h
/// The one way the method runs loops on threads, reports progress and gives up when asked.

#ifndef arris_Parallel_h
#define arris_Parallel_h

#include "Types.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <functional>

#ifdef __SANITIZE_THREAD__
#include <cstdint>
#include <thread>
#include <vector>
#endif

namespace arris
{
/// Hears how far a stage has come, and may ask it to stop. Always called on the caller's thread, so
/// that observers written in Python or drawing on a screen are safe.
class Monitor
{
public:
  Monitor() = default;
  explicit Monitor(std::function<bool(double)> report)
    : ReportFunction(std::move(report))
  {
  }

  /// Tells that a fraction (0 to 1) of the work is done; false when the work is to stop.
  bool Report(double fraction) const
  {
    return !this->ReportFunction || this->ReportFunction(this->Low + fraction * this->Extent);
  }

  /// A monitor for one of several stages, whose 0 and 1 are `low` and `high` of this one.
  Monitor Part(double low, double high) const
  {
    Monitor part(*this);
    part.Low = this->Low + low * this->Extent;
    part.Extent = (high - low) * this->Extent;
    return part;
  }

private:
  std::function<bool(double)> ReportFunction;
  double Low = 0.0;
  double Extent = 1.0;
};

/// Calls body(begin, end) for stretches that cover [first, last), on vtkSMPTools' threads.
template <typename Body>
void ParallelFor(Index first, Index last, Body&& body)
{
#ifdef __SANITIZE_THREAD__
  // vtkSMPTools hands stretches out under a lock. That orders those which happen not to overlap in
  // time, and hides the races of small meshes: only threads of their own stay unordered.
  constexpr std::int64_t Stretches = 3;
  std::vector<std::thread> threads;
  for (std::int64_t i = 0; i < Stretches; ++i)
  {
    const auto begin = first + static_cast<Index>((last - first) * i / Stretches);
    const auto end = first + static_cast<Index>((last - first) * (i + 1) / Stretches);
    if (begin < end)
    {
      threads.emplace_back([&body, begin, end] { body(begin, end); });
    }
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
#else
  vtkSMPTools::For(first, last,
    [&](vtkIdType begin, vtkIdType end)
    { body(static_cast<Index>(begin), static_cast<Index>(end)); });
#endif
}

/// The same for [0, count).
template <typename Body>
void ParallelFor(Index count, Body&& body)
{
  ParallelFor(0, count, body);
}

/// The same, with word to a monitor between slabs of the range. False if it asked to stop, and
/// then the rest of the range was left undone.
template <typename Body>
bool ParallelFor(Index count, const Monitor& monitor, Body&& body)
{
  // Few enough slabs that waiting for the slowest thread at the end of each costs nothing, enough
  // that an abort is felt at once.
  constexpr Index SmallestSlab = 20000;
  constexpr Index MostSlabs = 50;
  const Index slab = std::max(SmallestSlab, count / MostSlabs + 1);
  for (Index first = 0; first < count; first += slab)
  {
    if (!monitor.Report(static_cast<double>(first) / count))
    {
      return false;
    }
    const Index last = count - first > slab ? first + slab : count;
    ParallelFor(first, last, body);
    if (last == count)
    {
      break; // also keeps `first` from overflowing
    }
  }
  return monitor.Report(1.0);
}
}

#endif
