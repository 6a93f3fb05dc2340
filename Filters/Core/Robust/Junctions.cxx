// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Junctions.h"

#include "Spread.h"

#include <algorithm>

namespace arris
{
namespace
{
/// As far from a junction sampling takes vertices off their face, in local scales: as from any
/// edge.
constexpr double JunctionReach = 1.6;

/// Whether a triangle has both vertices.
bool HasEdge(const Triangle& triangle, Index a, Index b)
{
  return std::count(triangle.begin(), triangle.end(), a) +
    std::count(triangle.begin(), triangle.end(), b) ==
    2;
}

/// Whether an edge is one that parts patches, rather than inside one or on a free boundary.
bool PartsPatches(const Mesh& mesh, const Connectivity& connectivity, Index a, Index b)
{
  int triangles = 0;
  bool parts = false;
  for (Index t : connectivity.TrianglesOfVertex[a])
  {
    if (!HasEdge(mesh.Triangles[t], a, b))
    {
      continue;
    }
    ++triangles;
    const int corner = CornerOf(mesh.Triangles[t], a);
    const int edge = mesh.Triangles[t][Next(corner)] == b ? corner : Next(Next(corner));
    parts = parts || connectivity.AcrossEdge[t][edge] == NoIndex;
  }
  return parts && triangles > 1;
}
}

void AddJunctions(const PatchesApart& apart, const std::vector<Vec3>& points,
  const std::vector<double>& scales, Flags& region)
{
  SpreadFrom(
    apart.Common, points, apart.Adjacency,
    [&](Index, double distance, Index from) { return distance <= JunctionReach * scales[from]; },
    [&](Index v, Index) { region[v] = 1; });
}

void BringTogether(const PatchesApart& apart, std::size_t wholeCount, std::vector<Vec3>& points)
{
  std::vector<int> parts(wholeCount, 1);
  for (std::size_t part = wholeCount; part < points.size(); ++part)
  {
    points[apart.WholeOf[part]] += points[part];
    ++parts[apart.WholeOf[part]];
  }
  for (std::size_t part = 0; part < points.size(); ++part)
  {
    const Index whole = apart.WholeOf[part];
    points[part] =
      part < wholeCount && parts[whole] > 1 ? Vec3(points[part] / parts[whole]) : points[whole];
  }
}

Labelling JoinParts(const PatchesApart& apart, std::size_t wholeCount, const Labelling& ofParts)
{
  Labelling joined;
  joined.FirstApexLabel = ofParts.FirstApexLabel;
  joined.Labels.assign(ofParts.Labels.begin(), ofParts.Labels.begin() + wholeCount);
  joined.SidesOf.assign(wholeCount, NoIndex);
  for (std::size_t part = 0; part < ofParts.SidesOf.size(); ++part)
  {
    if (ofParts.SidesOf[part] == NoIndex)
    {
      continue;
    }
    Index& sidesOf = joined.SidesOf[apart.WholeOf[part]];
    if (sidesOf == NoIndex)
    {
      sidesOf = static_cast<Index>(joined.Sides.size());
      joined.Sides.emplace_back();
    }
    for (const Side& side : ofParts.Sides[ofParts.SidesOf[part]])
    {
      if (FindSide(joined.Sides[sidesOf], side.Patch) == nullptr)
      {
        joined.Sides[sidesOf].push_back(side);
      }
    }
  }
  return joined;
}

Flags InsideJunctions(const Mesh& whole, const Connectivity& connectivity)
{
  Flags inside(whole.Points.size(), 0);
  for (Index v = 0; v < whole.VertexCount() && !connectivity.Common.empty(); ++v)
  {
    if (connectivity.Common[v])
    {
      const IndexSpan neighbors = connectivity.NeighborsOfVertex[v];
      inside[v] = std::count_if(neighbors.begin(), neighbors.end(),
                    [&](Index n) { return PartsPatches(whole, connectivity, v, n); }) == 2;
    }
  }
  return inside;
}
}
