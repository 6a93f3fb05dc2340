// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Mender.h
/// The two ways of mending folded triangles: to slide a vertex, and to give triangles to another
/// face.

#ifndef arris_Robust_Mender_h
#define arris_Robust_Mender_h

#include "FanWorth.h"

#include <functional>

namespace arris
{
/// Vertices with more triangles than any sampling makes are not worked on: their fans come from
/// tessellation, and trying all moves there would take the square of their size.
constexpr Index LargestFan = 32;

/// Triangles of one label that are shut in with `bad` between edges of the ridge: where the ridge
/// runs past a chord of itself, they have no room. Empty if there are too many for that, or one of
/// them that may not be.
std::vector<Index> PocketOf(const Mesh& mesh, const Connectivity& connectivity,
  const Placement& placement, Index bad, const std::function<bool(Index triangle)>& mayBe);

/// Mends triangles. Keeps its working memory: use one object a thread.
class Mender
{
public:
  Mender(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales,
    Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , Scales(scales)
    , ThePlacement(placement)
    , Fan(mesh, connectivity, placement)
  {
  }

  /// Moves a vertex, while it is held, to where the triangles around it are worth most.
  void Slide(Index v);

  /// Gives the triangle, or with it what bears its label around one of its corners, or its pocket,
  /// to the face of one of its neighbours, if that is worth it.
  void Relabel(Index bad, const std::function<bool(Index triangle)>& mayBeInPocket);

  std::vector<Index> Moved; ///< vertices that have been
  std::vector<Index> Tried; ///< these, and those that had a better place under another label

private:
  /// Of all ways to relabel the best one so far.
  struct Best
  {
    double Gain;
    Index Label = NoIndex;
    std::vector<Index> Group;
  };

  std::vector<Index> LabelsAround(Index bad) const;
  std::vector<std::vector<Index>> GroupsWith(
    Index bad, const std::function<bool(Index triangle)>& mayBeInPocket) const;
  std::vector<Index> Sector(Index v, Index label) const;
  bool IsAllDamaged(const std::vector<Index>& group) const;
  void TryLabels(const std::vector<Index>& group, const std::vector<Index>& labels, Best& best);
  void Apply(const std::vector<Index>& group, Index label, const std::vector<Index>& vertices);
  double WorthOf(const std::vector<Index>& triangles) const;

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const std::vector<double>& Scales;
  Placement& ThePlacement;
  FanWorth Fan;
};
}

#endif
