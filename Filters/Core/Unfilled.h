// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Unfilled.h
/// A vector for what threads write right after.

#ifndef arris_Unfilled_h
#define arris_Unfilled_h

#include <memory>
#include <utility>
#include <vector>

namespace arris
{
/// Leaves new elements of plain types as they are in memory, where std::allocator writes zeros.
template <typename T>
struct UnfilledAllocator : std::allocator<T>
{
  template <typename U>
  struct rebind
  {
    using other = UnfilledAllocator<U>;
  };

  UnfilledAllocator() = default;
  template <typename U>
  UnfilledAllocator(const UnfilledAllocator<U>&)
  {
  }

  template <typename U>
  void construct(U* at)
  {
    ::new (static_cast<void*>(at)) U;
  }
  template <typename U, typename... Args>
  void construct(U* at, Args&&... args)
  {
    ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
  }
};

/// A vector whose resize() does not fill it: the threads that write it are the first to touch its
/// memory, which half of the time goes into where one thread does. All of it has to be written.
template <typename T>
using Unfilled = std::vector<T, UnfilledAllocator<T>>;
}

#endif
