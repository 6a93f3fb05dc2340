// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Decisions.h
/// Reads a fuzzer's bytes as a row of decisions; when they are used up, each is the first choice.

#ifndef arris_testing_Decisions_h
#define arris_testing_Decisions_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>

namespace arris
{
namespace testing
{
class Decisions
{
public:
  Decisions(const std::uint8_t* data, std::size_t size)
    : At(data)
    , End(data + size)
  {
  }

  bool AreUsedUp() const { return this->At == this->End; }

  std::uint8_t Byte() { return this->AreUsedUp() ? 0 : *this->At++; }

  /// 0 to count - 1.
  int Choice(int count) { return this->Byte() % count; }

  bool Yes() { return (this->Byte() & 1) != 0; }

  /// 0 to count - 1, of many.
  std::int64_t Id(std::int64_t count)
  {
    const std::int64_t number = this->Byte() | (this->Byte() << 8);
    return count > 0 ? number % count : 0;
  }

  /// Any double, often one at a limit.
  double Number()
  {
    using Limits = std::numeric_limits<double>;
    constexpr double Special[] = { 0.0, 1.0, -1.0, 0.5, 30.0, 180.0, 1e-9, 1e9, -0.0, 1e-30, 1e30,
      Limits::denorm_min(), Limits::min(), 1e-160, 1e160, 1e19, Limits::max(), -Limits::max(),
      Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN() };
    const int kind = this->Byte();
    if (kind < static_cast<int>(std::size(Special)))
    {
      return Special[kind];
    }
    if (kind < 200)
    {
      return (this->Byte() - 64) / 16.0;
    }
    double any = 0.0;
    const std::size_t count = std::min<std::size_t>(sizeof(any), this->End - this->At);
    if (count > 0)
    {
      std::memcpy(&any, this->At, count);
      this->At += count;
    }
    return any;
  }

private:
  const std::uint8_t* At;
  const std::uint8_t* End;
};
}
}

#endif
