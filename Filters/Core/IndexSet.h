// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file IndexSet.h
/// A set of a few dozen indices that is emptied and filled again millions of times.

#ifndef arris_IndexSet_h
#define arris_IndexSet_h

#include "Types.h"

#include <algorithm>

namespace arris
{
/// Open addressing in a table of a power of two. Clearing costs nothing: an entry counts only if it
/// bears the current stamp. (std::unordered_set allocates a node for every insertion, and a mark on
/// every triangle costs the memory of the mesh once for each thread.)
class IndexSet
{
public:
  IndexSet()
    : Slots(InitialSlots)
  {
  }

  void Clear()
  {
    this->Count = 0;
    if (++this->Stamp == 0) // wrapped round after four thousand million windows
    {
      std::fill(this->Slots.begin(), this->Slots.end(), Slot());
      this->Stamp = 1;
    }
  }

  /// True if the index was not in the set.
  bool Insert(Index value)
  {
    if (2 * (this->Count + 1) > this->Slots.size())
    {
      this->Grow();
    }
    Slot& slot = this->Find(value);
    if (slot.Stamp == this->Stamp)
    {
      return false;
    }
    slot = { value, this->Stamp };
    ++this->Count;
    return true;
  }

private:
  struct Slot
  {
    Index Value = NoIndex;
    std::uint32_t Stamp = 0;
  };
  static constexpr std::size_t InitialSlots = 256;

  /// The slot that holds the value, or the free one where it belongs.
  Slot& Find(Index value)
  {
    constexpr std::uint64_t Golden = 0x9E3779B97F4A7C15u; // 2^64 / golden ratio (Knuth's hash)
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t at = (static_cast<std::uint64_t>(value) * Golden >> 32) & mask;
    while (this->Slots[at].Stamp == this->Stamp && this->Slots[at].Value != value)
    {
      at = (at + 1) & mask;
    }
    return this->Slots[at];
  }

  void Grow()
  {
    std::vector<Slot> old(2 * this->Slots.size());
    old.swap(this->Slots);
    for (const Slot& slot : old)
    {
      if (slot.Stamp == this->Stamp)
      {
        this->Find(slot.Value) = slot;
      }
    }
  }

  std::vector<Slot> Slots;
  std::size_t Count = 0;
  std::uint32_t Stamp = 1;
};
}

#endif
