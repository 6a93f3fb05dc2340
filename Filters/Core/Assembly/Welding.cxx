// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Welding.h"

#include "CoincidentPoints.h"
#include "Core/Flagged.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace arris
{
namespace
{
/// The id of a vertex's first triangle.
Index IdAt(const Connectivity& connectivity, const std::vector<Index>& ids, Index vertex)
{
  return ids.empty() ? 0 : ids[connectivity.TrianglesOfVertex[vertex][0]];
}

/// For each of the used vertices the lowest at its position. Where that would join the ends of an
/// edge, the positions are what the mesh tells apart, however near they are to each other: then
/// only those that are the same to the last bit are one.
std::vector<Index> LowestOfPosition(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Index>& used, double tolerance)
{
  std::vector<Index> lowest = LowestCoincident(mesh.Points, used, tolerance);
  std::vector<Index> lowestOf(mesh.Points.size(), NoIndex);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    lowestOf[used[i]] = lowest[i];
  }
  Flags told(mesh.Points.size(), 0); // by the lowest vertex of a position
  for (const Index v : used)
  {
    for (const Index n : connectivity.NeighborsOfVertex[v])
    {
      told[lowestOf[v]] |=
        static_cast<unsigned char>(lowestOf[v] == lowestOf[n] && mesh.Points[v] != mesh.Points[n]);
    }
  }
  std::vector<Index> apart;
  std::copy_if(used.begin(), used.end(), std::back_inserter(apart),
    [&](Index v) { return told[lowestOf[v]] != 0; });
  const std::vector<Index> same = LowestCoincident(mesh.Points, apart, 0.0);
  auto next = same.begin();
  for (Index& one : lowest)
  {
    one = told[one] ? *next++ : one;
  }
  return lowest;
}
}

std::vector<Index> WeldedVertices(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<Index>& ids, double tolerance)
{
  std::vector<Index> used;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (!connectivity.TrianglesOfVertex[v].empty())
    {
      used.push_back(v);
    }
  }
  const Flags open = OpenVertices(mesh, connectivity);
  if (ids.empty())
  {
    used = MayCoincideWith(Flagged(open), mesh.Points, used, tolerance);
  }
  const std::vector<Index> lowest = LowestOfPosition(mesh, connectivity, used, tolerance);
  Flags meets(mesh.Points.size(), 0); // by the lowest vertex of a position
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    const bool otherId = IdAt(connectivity, ids, used[i]) != IdAt(connectivity, ids, lowest[i]);
    meets[lowest[i]] |= static_cast<unsigned char>(open[used[i]] || otherId);
  }
  std::vector<Index> welded(mesh.Points.size());
  std::iota(welded.begin(), welded.end(), 0);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (meets[lowest[i]])
    {
      welded[used[i]] = lowest[i];
    }
  }
  return welded;
}

void WeldTriangles(
  const std::vector<Index>& welded, Mesh& mesh, std::vector<Index>& ids, std::vector<Index>& kept)
{
  // Triangles by their three vertices, ascending; those on the same three one after the other.
  std::vector<std::pair<Triangle, Index>> byVertices;
  byVertices.reserve(mesh.Triangles.size());
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    Triangle& triangle = mesh.Triangles[t];
    for (Index& vertex : triangle)
    {
      vertex = welded[vertex];
    }
    Triangle key = triangle;
    std::sort(key.begin(), key.end());
    if (key[0] != key[1] && key[1] != key[2])
    {
      byVertices.emplace_back(key, t);
    }
  }
  std::sort(byVertices.begin(), byVertices.end());

  std::map<std::vector<Index>, Index> idOfSet;
  Index nextId = ids.empty() ? 0 : 1 + *std::max_element(ids.begin(), ids.end());
  kept.clear();
  for (auto first = byVertices.begin(); first != byVertices.end();)
  {
    const auto last = std::find_if(
      first, byVertices.end(), [&](const auto& entry) { return entry.first != first->first; });
    kept.push_back(first->second);
    if (!ids.empty() && last - first > 1)
    {
      std::set<Index> several;
      std::for_each(first, last, [&](const auto& entry) { several.insert(ids[entry.second]); });
      if (several.size() > 1)
      {
        const auto [found, isNew] =
          idOfSet.emplace(std::vector<Index>(several.begin(), several.end()), nextId);
        nextId += isNew ? 1 : 0;
        ids[first->second] = found->second;
      }
    }
    first = last;
  }
  std::sort(kept.begin(), kept.end());
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    mesh.Triangles[i] = mesh.Triangles[kept[i]];
    if (!ids.empty())
    {
      ids[i] = ids[kept[i]];
    }
  }
  mesh.Triangles.resize(kept.size());
  ids.resize(ids.empty() ? 0 : kept.size());
}
}
