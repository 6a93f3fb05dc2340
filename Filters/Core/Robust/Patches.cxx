// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Patches.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace arris
{
namespace
{
/// How far a patch's normals may stray from that of its seed, in degrees. Over-segmenting is
/// harmless: sheets are fitted across patches of like normal.
constexpr double PatchSpread = 20.0;

/// The same on narrow faces, where the normals of vertices are spoilt by the edges beside.
constexpr double NarrowSpread = 50.0;

constexpr std::size_t SmallestPiece = 3;

/// Floods from `seed` over vertices that `accepts`; `id` marks them.
template <typename Accepts>
std::vector<Index> Flood(const Connectivity& connectivity, Index seed, Index id,
  std::vector<Index>& ids, Accepts&& accepts)
{
  std::vector<Index> group(1, seed);
  ids[seed] = id;
  for (std::size_t next = 0; next < group.size(); ++next)
  {
    for (Index n : connectivity.NeighborsOfVertex[group[next]])
    {
      if (ids[n] == NoIndex && accepts(n))
      {
        ids[n] = id;
        group.push_back(n);
      }
    }
  }
  return group;
}

/// Sorts vertices into classes of λτ, flattest first. The order within a class is theirs:
/// ascending.
Rows SortIntoClasses(const std::vector<double>& flatness, const std::vector<Index>& vertices)
{
  // Powers of two, four classes to each from 2^-48 on: under that all is rounding.
  constexpr int Finest = -48;
  constexpr int PerPower = 4;
  constexpr int Classes = PerPower * (2 - Finest) + 1;
  const auto classOf = [&](Index v)
  {
    int power = 0;
    const double mantissa = std::frexp(flatness[v], &power); // 0.5 to 1
    const int step = static_cast<int>((mantissa - 0.5) * 2.0 * PerPower);
    return flatness[v] > 0.0 ? std::clamp(PerPower * (power - Finest) + step + 1, 1, Classes - 1)
                             : 0;
  };
  Rows rows;
  rows.Offsets.assign(Classes + 1, 0);
  for (Index v : vertices)
  {
    ++rows.Offsets[classOf(v) + 1];
  }
  std::partial_sum(rows.Offsets.begin(), rows.Offsets.end(), rows.Offsets.begin());
  rows.Values.resize(vertices.size());
  std::vector<Index> next(rows.Offsets.begin(), rows.Offsets.end() - 1);
  for (Index v : vertices)
  {
    rows.Values[next[classOf(v)]++] = v;
  }
  return rows;
}

/// Floods patches over what is intact and in none yet, from the flattest seeds on.
void FloodPatches(const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& flatness, const Flags& region, double spread,
  const std::vector<Index>& seeds, Patches& patches)
{
  const double leastCosine = std::cos(spread * Pi / 180.0);
  const Rows classes = SortIntoClasses(flatness, seeds);
  std::vector<Index> open;
  for (Index c = 0; c < classes.size(); ++c)
  {
    // The first few patches take nearly all vertices; only what they leave needs to be sorted.
    open.clear();
    std::copy_if(classes[c].begin(), classes[c].end(), std::back_inserter(open),
      [&](Index v) { return patches.PatchOf[v] == NoIndex; });
    std::stable_sort(
      open.begin(), open.end(), [&](Index a, Index b) { return flatness[a] < flatness[b]; });
    for (Index seed : open)
    {
      if (patches.PatchOf[seed] == NoIndex)
      {
        const Vec3& normal = faces.VertexNormals[seed];
        Flood(connectivity, seed, patches.PatchCount++, patches.PatchOf,
          [&](Index n) { return !region[n] && faces.VertexNormals[n].dot(normal) >= leastCosine; });
      }
    }
  }
}
}

Patches SortIntoPatches(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& flatness, Flags& region)
{
  Patches patches;
  patches.PieceOf.assign(mesh.Points.size(), NoIndex);
  Index pieces = 0;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (region[v] || patches.PieceOf[v] != NoIndex)
    {
      continue;
    }
    const std::vector<Index> piece =
      Flood(connectivity, v, pieces, patches.PieceOf, [&](Index n) { return !region[n]; });
    if (piece.size() < SmallestPiece)
    {
      for (Index member : piece)
      {
        region[member] = 1;
        patches.PieceOf[member] = NoIndex;
      }
      continue;
    }
    ++pieces;
  }

  patches.PieceCount = pieces;
  patches.PatchOf.assign(mesh.Points.size(), NoIndex);
  std::vector<Index> intact;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (!region[v])
    {
      intact.push_back(v);
    }
  }
  FloodPatches(connectivity, faces, flatness, region, PatchSpread, intact, patches);
  return patches;
}

void AddNarrowPatches(const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& flatness, const Flags& region, const std::vector<Index>& released,
  Patches& patches)
{
  for (Index v : released)
  {
    if (patches.PieceOf[v] == NoIndex)
    {
      Flood(connectivity, v, patches.PieceCount++, patches.PieceOf,
        [&](Index n) { return !region[n]; });
    }
  }
  FloodPatches(connectivity, faces, flatness, region, NarrowSpread, released, patches);
}
}
