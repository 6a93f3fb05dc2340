// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file OwnOrder.h
/// The order that vertices and triangles have by where they are, however a mesh numbers them.

#ifndef arris_Robust_OwnOrder_h
#define arris_Robust_OwnOrder_h

#include "Core/Mesh.h"
#include "Core/Parallel.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// For each new number the old one.
struct OwnOrder
{
  std::vector<Index> Vertices;
  std::vector<Index> Triangles;
};

/// What each new number stands for, taken from what is there for each old one.
template <typename Item>
std::vector<Item> InOrder(const std::vector<Index>& order, const std::vector<Item>& old)
{
  std::vector<Item> items(order.size());
  ParallelFor(static_cast<Index>(order.size()),
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        items[i] = old[order[i]];
      }
    });
  return items;
}

/// Renumbers a mesh: vertices along a curve that fills space, and triangles by their corners, of
/// which each starts with its lowest. Vertices at one point come by where their neighbours are, and
/// keep their order only if that is the same, too.
ARRISFILTERS_EXPORT OwnOrder PutInOwnOrder(Mesh& mesh, const Connectivity& connectivity);

/// The connectivity of a mesh that was renumbered. What was across an edge still is.
ARRISFILTERS_EXPORT Connectivity Renumbered(const Connectivity& connectivity,
  const std::vector<Triangle>& before, const OwnOrder& order, const std::vector<Triangle>& after);
}

#endif
