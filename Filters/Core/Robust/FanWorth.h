// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FanWorth.h
/// What the triangles of a placement are worth: how good their shape is, and none turned over.

#ifndef arris_Robust_FanWorth_h
#define arris_Robust_FanWorth_h

#include "Placement.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <limits>

namespace arris
{
/// The most that triangles can be worth: those that are good enough count alike.
inline double MostWorth(std::size_t triangles)
{
  return GoodEnoughQuality * static_cast<double>(triangles);
}

/// The worth of triangles as they are placed; to have one turned over is worse than any shape. What
/// is worth no more than `least` is not looked at to its end.
ARRISFILTERS_EXPORT double WorthOf(const Mesh& mesh, const Connectivity& connectivity,
  const Placement& placement, IndexSpan triangles,
  double least = -std::numeric_limits<double>::infinity());

/// The worth of the triangles around one vertex that is tried at many points, while all others, and
/// the labels, stay. Keeps its working memory: use one object a thread.
class ARRISFILTERS_EXPORT FanWorth
{
public:
  FanWorth(const Mesh& mesh, const Connectivity& connectivity, const Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , ThePlacement(placement)
  {
  }

  void Take(Index vertex);

  /// The same as WorthOf the triangles, with the vertex where it is placed now.
  double Now(double least = -std::numeric_limits<double>::infinity());

private:
  struct Blade
  {
    Index Triangle;
    const Sheet* Surface; ///< its face; null if unknown
    Vec3 Before; ///< its area vector in the mesh
    Vec3 Other; ///< one that is known not to be faced against by some place of it
    std::array<Index, 3> Across; ///< of each edge: which blade; NoIndex if none
    std::array<Vec3, 3> Beyond; ///< else the area vector that is there; zero if none
    Vec3 Area; ///< with the vertex where it is now, if `Known`
    bool Known;
  };

  double QualityOf(Blade& blade) const;
  const Vec3& AreaOf(Blade& blade) const;
  bool IsOver(Blade& blade);

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Placement& ThePlacement;
  std::vector<Blade> Blades;
};
}

#endif
