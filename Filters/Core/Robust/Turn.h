// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Turn.h
/// How much the surface turns at a vertex, and how much of that its sides account for.

#ifndef arris_Robust_Turn_h
#define arris_Robust_Turn_h

#include "Core/ConnectedWindow.h"
#include "Core/NormalSpread.h"
#include "Faces.h"

namespace arris
{
/// The radius of the window, in local scales.
constexpr double TurnWindow = 0.75;

/// Angles in degrees; all zero where the window is flat.
struct Turn
{
  double Deviation = 0.0; ///< the paper's: the largest angle between two normals in the window
  double Across = 0.0; ///< T: the same, but across the edge only
  double Concentrated = 0.0; ///< E = T less what the curvature of the sides gives over the window
  double Jump = 0.0; ///< J: what is left of the turn once both sides are extrapolated to v
  double WideJump = 0.0; ///< J again from sides that start and end half an edge farther out
};

/// Measures the turn at vertices. Keeps its working memory: use one object a thread.
class TurnMeter
{
public:
  TurnMeter(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
    const std::vector<double>& scales);

  Turn Measure(Index vertex);

private:
  /// A face as a vertex sees it: how far across the edge and along it, in local scales.
  struct SeenFace
  {
    Vec3 Offset; ///< centroid minus vertex, in local scales
    Index Face;
  };
  /// The normals of one side as a line a + b s over the distance s across the edge.
  struct Side
  {
    Vec3 Intercept;
    Vec3 Slope;
    Vec3 Mean;
    bool Known = false;
  };

  void GatherNear(Index vertex, double radius);
  Side FitSide(
    const Vec3& across, const Vec3& along, double sign, double nearest, double farthest) const;
  double JumpOf(const Side& left, const Side& right, const Vec3& across) const;
  void MeasureAcross(
    const Vec3& meanNormal, const Vec3& across, const std::vector<Index>& window, Turn& turn) const;

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Faces& TheFaces;
  const std::vector<double>& Scales;
  ConnectedWindow Window;
  NormalSpread Spread;
  IndexSet Seen;
  std::vector<SeenFace> Near;
  double Scale = 0.0;
  Vec3 Position;
};
}

#endif
