// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file SortUnique.h
/// Puts what was collected in order, each once: so that it does not matter who collected it when.

#ifndef arris_SortUnique_h
#define arris_SortUnique_h

#include <algorithm>
#include <vector>

namespace arris
{
template <typename Item>
void SortUnique(std::vector<Item>& items)
{
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}
}

#endif
