// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GiveBack.h"

#include "Core/Flagged.h"
#include "Creases.h"

#include <algorithm>

namespace arris
{
void GiveBackTheMoreCreased(const Mesh& mesh, const Connectivity& connectivity, const Flags& region,
  const std::vector<Vec3>& input, Placement& placement)
{
  ForEachGroup(connectivity, region, 1,
    [&](const std::vector<Index>& part)
    {
      double before = 0.0, after = 0.0;
      for (Index v : part)
      {
        // Most edges are counted from more than one vertex, but the same ones on either side.
        before += CreasesAround(mesh.Triangles, connectivity, input, v);
        after += CreasesAround(mesh.Triangles, connectivity, placement.AllPoints(), v);
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
    });
}
}
