// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GiveBack.h"

#include "Core/Flagged.h"
#include "Core/Parallel.h"
#include "Creases.h"

#include <algorithm>
#include <array>

namespace arris
{
std::vector<Index> GiveBackTheMoreCreased(const Mesh& mesh, const Connectivity& connectivity,
  const Flags& region, const std::vector<Vec3>& input, Placement& placement)
{
  std::vector<Index> givenBack;
  ForEachGroup(connectivity, region, 1,
    [&](const std::vector<Index>& part)
    {
      // Most edges are counted from more than one vertex, but the same ones on either side.
      std::vector<std::array<double, 2>> creases(part.size());
      ParallelFor(static_cast<Index>(part.size()),
        [&](Index begin, Index end)
        {
          for (Index i = begin; i < end; ++i)
          {
            creases[i] = { CreasesAround(mesh.Triangles, connectivity, input, part[i]),
              CreasesAround(mesh.Triangles, connectivity, placement.AllPoints(), part[i]) };
          }
        });
      double before = 0.0, after = 0.0;
      for (const std::array<double, 2>& of : creases)
      {
        before += of[0];
        after += of[1];
      }
      // A tip has more creases than what is left of one when it has been cut off.
      const bool tip =
        std::any_of(part.begin(), part.end(), [&](Index v) { return placement.IsPinned(v); });
      if (after <= before || tip)
      {
        return;
      }
      for (Index v : part)
      {
        placement.Put(v, input[v], {});
      }
      givenBack.insert(givenBack.end(), part.begin(), part.end());
    });
  return givenBack;
}
}
