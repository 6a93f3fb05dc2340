// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ExactSum.h
/// Sums that are the same to the last bit in whatever order and on however many threads.

#ifndef arris_ExactSum_h
#define arris_ExactSum_h

#include "Parallel.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>

namespace arris
{
/// A sum of numbers from -1 to 1. Each is taken as a whole number of 2^-60, and whole numbers add
/// up without rounding; there may be 2^31 of them.
class ExactSum
{
public:
  void Add(double value)
  {
    const double high = std::nearbyint(value * Unit);
    this->High += static_cast<std::int64_t>(high);
    this->Low += static_cast<std::int64_t>(std::nearbyint((value * Unit - high) * Unit));
  }
  void Add(const ExactSum& other)
  {
    this->High += other.High;
    this->Low += other.Low;
  }
  double Value() const
  {
    return (static_cast<double>(this->High) + static_cast<double>(this->Low) / Unit) / Unit;
  }

private:
  static constexpr double Unit = 1 << 30;

  std::int64_t High = 0; ///< in 2^-30
  std::int64_t Low = 0; ///< in 2^-60: what is left of each number
};

/// Several sums, from 0 to count on all threads: add(i, sums) adds what i has to them.
template <std::size_t Size, typename Add>
std::array<ExactSum, Size> ExactSums(Index count, Add&& add)
{
  std::array<ExactSum, Size> sums;
  std::mutex mutex;
  ParallelFor(count,
    [&](Index begin, Index end)
    {
      std::array<ExactSum, Size> own;
      for (Index i = begin; i < end; ++i)
      {
        add(i, own);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      for (std::size_t k = 0; k < Size; ++k)
      {
        sums[k].Add(own[k]);
      }
    });
  return sums;
}
}

#endif
