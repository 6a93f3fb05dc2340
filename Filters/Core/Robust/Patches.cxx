// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Patches.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>
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

/// Floods patches over what is intact and in none yet, from the flattest seeds on.
void FloodPatches(const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& flatness, const Flags& region, double spread, std::vector<Index> seeds,
  Patches& patches)
{
  std::stable_sort(
    seeds.begin(), seeds.end(), [&](Index a, Index b) { return flatness[a] < flatness[b]; });
  const double leastCosine = std::cos(spread * Pi / 180.0);
  for (Index seed : seeds)
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
