// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Slivers.h"

#include <algorithm>
#include <map>

namespace arris
{
namespace
{
constexpr Index MostTriangles = 4;
constexpr Index TimesAsMany = 50;
constexpr double TimesAsLarge = 4.0; // by edges twice as long, as dents have them

/// A real small face folds about as much to all sides; a tilted triangle lies at one.
constexpr double LeastToMost = 0.75;

/// What two faces have in common.
struct Border
{
  double Length = 0.0;
  double AngleTimesLength = 0.0;

  double MeanAngle() const
  {
    return this->Length > 0.0 ? this->AngleTimesLength / this->Length : 0.0;
  }
};

using Neighbors = std::map<Index, Border>; // NoIndex: the boundary and non-manifold edges

std::array<Index, 2> FacesBeside(const FeatureEdge& edge, const Surfaces& faces)
{
  const auto face = [&](Index t) { return t == NoIndex ? NoIndex : faces.Ids[t]; };
  return { face(edge.Left), face(edge.Right) };
}

bool IsSmall(Index face, const Surfaces& faces)
{
  return face != NoIndex && faces.Measures[face].Triangles <= MostTriangles;
}

/// The borders of all small faces with others: where some lie together, what is among them does not
/// say where they belong.
std::map<Index, Neighbors> BordersOfSmallFaces(
  const Mesh& mesh, const Surfaces& faces, const std::vector<FeatureEdge>& features)
{
  std::map<Index, Neighbors> borders;
  for (const FeatureEdge& edge : features)
  {
    const std::array<Index, 2> beside = FacesBeside(edge, faces);
    const double length = (mesh.Points[edge.B] - mesh.Points[edge.A]).norm();
    for (const int side : { 0, 1 })
    {
      const Index face = beside[side];
      const Index other = IsFold(edge.Kind) ? beside[1 - side] : NoIndex;
      if (IsSmall(face, faces) && !IsSmall(other, faces))
      {
        Border& border = borders[face][other];
        border.Length += length;
        border.AngleTimesLength += length * edge.DihedralAngle;
      }
    }
  }
  return borders;
}

/// The face that a small one belongs to, or NoIndex.
Index BelongsTo(Index face, const Neighbors& neighbors, const Surfaces& faces)
{
  const auto folds = [](const auto& a, const auto& b)
  { return a.second.MeanAngle() < b.second.MeanAngle(); };
  const auto [least, most] = std::minmax_element(neighbors.begin(), neighbors.end(), folds);
  if (neighbors.begin()->first == NoIndex || // the lowest key
    (neighbors.size() > 1 && least->second.MeanAngle() > LeastToMost * most->second.MeanAngle()))
  {
    return NoIndex;
  }
  const SurfaceMeasures& small = faces.Measures[face];
  const SurfaceMeasures& large = faces.Measures[least->first];
  const bool isOfItsTriangles = large.Triangles >= TimesAsMany * small.Triangles &&
    small.Area * large.Triangles <= TimesAsLarge * large.Area * small.Triangles;
  return isOfItsTriangles ? least->first : NoIndex;
}
}

bool DropSlivers(const Mesh& mesh, const Surfaces& faces, std::vector<FeatureEdge>& features)
{
  std::map<Index, Index> owners;
  for (const auto& [face, neighbors] : BordersOfSmallFaces(mesh, faces, features))
  {
    const Index owner = BelongsTo(face, neighbors, faces);
    if (owner != NoIndex)
    {
      owners[face] = owner;
    }
  }
  const auto isInside = [&](const FeatureEdge& edge)
  {
    const auto [left, right] = FacesBeside(edge, faces);
    const auto ownerOf = [&](Index face)
    {
      const auto owner = owners.find(face);
      return owner != owners.end() ? owner->second : face;
    };
    return left != right && ownerOf(left) == ownerOf(right);
  };
  const auto kept = std::remove_if(features.begin(), features.end(), isInside);
  const bool any = kept != features.end();
  features.erase(kept, features.end());
  return any;
}
}
