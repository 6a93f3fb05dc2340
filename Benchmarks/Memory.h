// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Memory.h
/// How much memory a piece of work takes at its peak (Linux).

#ifndef arris_benchmarks_Memory_h
#define arris_benchmarks_Memory_h

#include <malloc.h>

#include <fstream>
#include <string>

namespace arris
{
namespace benchmarks
{
/// A line of /proc/self/status in bytes; 0 if there is none.
inline double BytesInStatus(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind(key + ':', 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(key.size() + 1));
    }
  }
  return 0.0;
}

/// By how many bytes the process grows at most while it does `work`.
template <typename Work>
double PeakBytes(Work&& work)
{
  malloc_trim(0); // or memory freed before would be taken again unseen
  std::ofstream("/proc/self/clear_refs") << "5"; // sets the high-water mark back
  const double before = BytesInStatus("VmRSS");
  work();
  return BytesInStatus("VmHWM") - before;
}
}
}

#endif
