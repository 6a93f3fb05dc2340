// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Assembly.h"

#include "Core/Parallel.h"
#include "Fans.h"
#include "Welding.h"

#include <algorithm>
#include <atomic>

namespace arris
{
namespace
{
/// Calls visit(triangle) for each triangle around edge k of `first`, that one first.
template <typename Visit>
void ForEachAround(
  const Mesh& mesh, const Connectivity& connectivity, Index first, int k, Visit&& visit)
{
  const Index a = mesh.Triangles[first][k];
  const Index b = mesh.Triangles[first][Next(k)];
  Index t = first;
  do
  {
    const Triangle& corners = mesh.Triangles[t];
    int edge = 0;
    while (!((corners[edge] == a && corners[Next(edge)] == b) ||
      (corners[edge] == b && corners[Next(edge)] == a)))
    {
      ++edge;
    }
    visit(t);
    t = connectivity.AcrossEdge[t][edge];
  } while (t != NoIndex && t != first);
}

bool HasSeveralIds(const std::vector<Index>& ids)
{
  return std::any_of(ids.begin(), ids.end(), [&](Index id) { return id != ids.front(); });
}

/// Whether each edge of a triangle has one other triangle that runs along it in the opposite
/// direction.
bool ContinuesAllRound(const Mesh& mesh, const Connectivity& connectivity, Index t)
{
  const Triangle& own = mesh.Triangles[t];
  for (int k = 0; k < 3; ++k)
  {
    const Index beyond = connectivity.AcrossEdge[t][k];
    if (beyond == NoIndex)
    {
      return false;
    }
    const Triangle& other = mesh.Triangles[beyond];
    const int from = CornerOf(other, own[Next(k)]);
    if (other[from] != own[Next(k)] || other[Next(from)] != own[k] ||
      connectivity.AcrossEdge[beyond][from] != t)
    {
      return false;
    }
  }
  return true;
}

bool IsClosedAndOriented(const Mesh& mesh, const Connectivity& connectivity)
{
  std::atomic<bool> all(true);
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        if (!ContinuesAllRound(mesh, connectivity, t))
        {
          all = false;
          return;
        }
      }
    });
  return all;
}

/// Finds across each edge of each triangle the one that continues its patch, and counts the edges
/// that do not have two triangles.
Unfilled<std::array<Index, 3>> Continuations(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Index>& ids, AssemblyFacts& facts)
{
  const auto idOf = [&](Index t) { return ids.empty() ? 0 : ids[t]; };
  Unfilled<std::array<Index, 3>> continuations(mesh.Triangles.size());
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      Index beyond = NoIndex;
      int ofPatch = 0, all = 0;
      bool isFirst = true;
      ForEachAround(mesh, connectivity, t, k,
        [&](Index other)
        {
          ++all;
          isFirst = isFirst && other >= t;
          if (other != t && idOf(other) == idOf(t))
          {
            beyond = other;
            ++ofPatch;
          }
        });
      continuations[t][k] = ofPatch == 1 ? beyond : NoIndex;
      facts.OpenEdges += all == 1 ? 1 : 0;
      facts.JunctionEdges += all > 2 && isFirst ? 1 : 0;
    }
  }
  return continuations;
}

/// Numbers what hangs together across edges; how many there are.
Index NumberPatches(const Connectivity& connectivity, std::vector<Index>& patchOf)
{
  patchOf.assign(connectivity.AcrossEdge.size(), NoIndex);
  Index patches = 0;
  std::vector<Index> front;
  for (std::size_t seed = 0; seed < patchOf.size(); ++seed)
  {
    if (patchOf[seed] != NoIndex)
    {
      continue;
    }
    front.assign(1, static_cast<Index>(seed));
    patchOf[seed] = patches;
    for (std::size_t next = 0; next < front.size(); ++next)
    {
      for (Index beyond : connectivity.AcrossEdge[front[next]])
      {
        if (beyond != NoIndex && patchOf[beyond] == NoIndex)
        {
          patchOf[beyond] = patches;
          front.push_back(beyond);
        }
      }
    }
    ++patches;
  }
  return patches;
}

/// Marks the vertices that several patches have, or several parts of one that an edge parts there,
/// and the ends of all edges of patches.
void MarkVertices(const Mesh& mesh, const Connectivity& uncut, Connectivity& connectivity)
{
  Flags parted(mesh.Points.size(), 0);
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (connectivity.AcrossEdge[t][k] == NoIndex)
      {
        for (Index v : { mesh.Triangles[t][k], mesh.Triangles[t][Next(k)] })
        {
          connectivity.OnBoundary[v] = 1;
          parted[v] |= static_cast<unsigned char>(uncut.AcrossEdge[t][k] != NoIndex);
        }
      }
    }
  }
  connectivity.Common.assign(mesh.Points.size(), 0);
  FanFinder finder(mesh, connectivity);
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    const IndexSpan around = connectivity.TrianglesOfVertex[v];
    const bool severalPatches = std::any_of(around.begin(), around.end(),
      [&](Index t) { return connectivity.PatchOf[t] != connectivity.PatchOf[around[0]]; });
    if (severalPatches || parted[v])
    {
      const std::vector<Index>& fans = finder.FansAround(v);
      connectivity.Common[v] = *std::max_element(fans.begin(), fans.end()) > 0 ? 1 : 0;
      connectivity.OnBoundary[v] |= connectivity.Common[v];
    }
  }
}
}

Assembly MakeAssembly(
  Mesh& mesh, Connectivity& connectivity, std::vector<Index> ids, double tolerance)
{
  Assembly assembly;
  if (!HasSeveralIds(ids) && IsClosedAndOriented(mesh, connectivity))
  {
    return assembly;
  }
  const std::size_t before = mesh.Triangles.size();
  assembly.SameAs = WeldedVertices(mesh, connectivity, ids, tolerance);
  WeldTriangles(assembly.SameAs, mesh, ids, assembly.Kept);
  assembly.Facts.LeftOutTriangles = static_cast<Index>(before - mesh.Triangles.size());
  const Connectivity uncut(mesh);
  connectivity = uncut;
  connectivity.AcrossEdge = Continuations(mesh, uncut, ids, assembly.Facts);
  assembly.Facts.Patches = NumberPatches(connectivity, connectivity.PatchOf);
  assembly.Facts.Orientation =
    OrientPatches(mesh, connectivity.PatchOf, assembly.Facts.Patches, uncut, connectivity);
  MarkVertices(mesh, uncut, connectivity);
  assembly.Facts.CommonVertices =
    static_cast<Index>(std::count(connectivity.Common.begin(), connectivity.Common.end(), 1));
  if (assembly.Facts.CommonVertices == 0)
  {
    connectivity.PatchOf.clear();
    connectivity.Common.clear();
  }
  return assembly;
}
}
