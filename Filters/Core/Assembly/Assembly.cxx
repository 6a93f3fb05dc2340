// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Assembly.h"

#include "Core/Parallel.h"
#include "Fans.h"
#include "Welding.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace arris
{
namespace
{
using AcrossEdges = Unfilled<std::array<Index, 3>>; // as in Connectivity

/// Calls visit(triangle) for each triangle around edge k of `first`, that one first.
template <typename Visit>
void ForEachAround(
  const Mesh& mesh, const AcrossEdges& acrossEdge, Index first, int k, Visit&& visit)
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
    t = acrossEdge[t][edge];
  } while (t != NoIndex && t != first);
}

bool HasSeveralIds(const std::vector<Index>& ids)
{
  return std::any_of(ids.begin(), ids.end(), [&](Index id) { return id != ids.front(); });
}

/// How the edges of a mesh go on.
struct EdgeFacts
{
  /// No edge has more than two triangles, and the two run along it in opposite directions.
  bool AllOriented = true;
  bool AllClosed = true; ///< each has two
  bool AnyTwice = false; ///< two neighbours have all vertices in common
};

/// Looks across the edges of one triangle.
EdgeFacts FactsOf(const Mesh& mesh, const Connectivity& connectivity, Index t)
{
  EdgeFacts facts;
  const Triangle& own = mesh.Triangles[t];
  for (int k = 0; k < 3; ++k)
  {
    const Index beyond = connectivity.AcrossEdge[t][k];
    if (beyond == NoIndex)
    {
      facts.AllClosed = false;
      continue;
    }
    const Triangle& other = mesh.Triangles[beyond];
    const int from = CornerOf(other, own[Next(k)]);
    facts.AllOriented = facts.AllOriented && other[from] == own[Next(k)] &&
      other[Next(from)] == own[k] && connectivity.AcrossEdge[beyond][from] == t;
    facts.AnyTwice = facts.AnyTwice || other[Next(Next(from))] == own[Next(Next(k))];
  }
  return facts;
}

EdgeFacts FactsOf(const Mesh& mesh, const Connectivity& connectivity)
{
  std::atomic<bool> oriented(true), closed(true), twice(false);
  ParallelFor(mesh.TriangleCount(),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const EdgeFacts facts = FactsOf(mesh, connectivity, t);
        if (!facts.AllOriented)
        {
          oriented = false;
        }
        if (!facts.AllClosed)
        {
          closed = false;
        }
        if (facts.AnyTwice)
        {
          twice = true;
        }
      }
    });
  return { oriented, closed, twice };
}

/// Finds across each edge of each triangle the one that continues its patch, and counts the edges
/// that do not have two triangles.
AcrossEdges Continuations(
  const Mesh& mesh, const AcrossEdges& uncut, const std::vector<Index>& ids, AssemblyFacts& facts)
{
  const auto idOf = [&](Index t) { return ids.empty() ? 0 : ids[t]; };
  AcrossEdges continuations(mesh.Triangles.size());
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      Index beyond = NoIndex;
      int ofPatch = 0, all = 0;
      bool isFirst = true;
      ForEachAround(mesh, uncut, t, k,
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

Index CountOpenEdges(const AcrossEdges& acrossEdge)
{
  Index open = 0;
  for (const std::array<Index, 3>& across : acrossEdge)
  {
    open += static_cast<Index>(std::count(across.begin(), across.end(), NoIndex));
  }
  return open;
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
void MarkVertices(const Mesh& mesh, const AcrossEdges& uncut, Connectivity& connectivity)
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
          parted[v] |= static_cast<unsigned char>(uncut[t][k] != NoIndex);
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

/// Whether any vertex is one with another.
bool IsWelded(const std::vector<Index>& sameAs)
{
  for (std::size_t v = 0; v < sameAs.size(); ++v)
  {
    if (sameAs[v] != static_cast<Index>(v))
    {
      return true;
    }
  }
  return false;
}
}

Assembly MakeAssembly(
  Mesh& mesh, Connectivity& connectivity, std::vector<Index> ids, double tolerance)
{
  Assembly assembly;
  AssemblyFacts& facts = assembly.Facts;
  if (!HasSeveralIds(ids))
  {
    ids.clear();
  }
  const EdgeFacts edges = FactsOf(mesh, connectivity);
  const bool inOrder = ids.empty() && edges.AllOriented;
  if (inOrder && edges.AllClosed)
  {
    return assembly;
  }
  assembly.SameAs = WeldedVertices(mesh, connectivity, ids, tolerance);
  if (inOrder && !edges.AnyTwice && !IsWelded(assembly.SameAs))
  {
    assembly.SameAs.clear();
    facts.OpenEdges = CountOpenEdges(connectivity.AcrossEdge);
    facts.Patches = NumberPatches(connectivity, connectivity.PatchOf);
    MarkVertices(mesh, connectivity.AcrossEdge, connectivity);
  }
  else
  {
    const std::size_t before = mesh.Triangles.size();
    WeldTriangles(assembly.SameAs, mesh, ids, assembly.Kept);
    facts.LeftOutTriangles = static_cast<Index>(before - mesh.Triangles.size());
    connectivity = Connectivity(mesh);
    const AcrossEdges uncut = std::move(connectivity.AcrossEdge);
    connectivity.AcrossEdge = Continuations(mesh, uncut, ids, facts);
    facts.Patches = NumberPatches(connectivity, connectivity.PatchOf);
    facts.Orientation =
      OrientPatches(mesh, connectivity.PatchOf, facts.Patches, uncut, connectivity);
    MarkVertices(mesh, uncut, connectivity);
  }
  facts.CommonVertices =
    static_cast<Index>(std::count(connectivity.Common.begin(), connectivity.Common.end(), 1));
  if (facts.CommonVertices == 0)
  {
    connectivity.PatchOf.clear();
    connectivity.Common.clear();
  }
  return assembly;
}
}
