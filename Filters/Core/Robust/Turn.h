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

/// A window with less deviation holds no edge, in degrees: nothing but it is looked at.
constexpr double FlatDeviation = 6.0;

/// Whether the window is flat, so that the turn was not looked into.
inline bool IsFlat(const Turn& turn)
{
  return turn.Across == 0.0 && turn.Jump == 0.0;
}

/// Measures the turn at vertices. Keeps its working memory: use one object a thread.
class TurnMeter
{
public:
  TurnMeter(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
    const std::vector<double>& scales);

  /// Looks past no triangle with two corners or more in `region`, from now on: what lies beyond
  /// another edge has no part in the turn. Of a side that ends there, what is left beside the
  /// vertex is taken, unless edges are rounded: then that is bent.
  void LookWithin(const Flags& region, bool rounded)
  {
    this->Barrier = &region;
    this->BelieveClose = !rounded;
  }

  Turn Measure(Index vertex);

private:
  /// A face as a vertex sees it.
  struct SeenFace
  {
    Vec3 Offset; ///< centroid minus vertex, in local scales
    Vec3 AreaVector; ///< normal to the face, its area long
    double Area;
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

  /// The sums that a side is fitted from.
  struct SideSums
  {
    double Area = 0.0;
    double S = 0.0;
    double SS = 0.0;
    Vec3 N = Vec3::Zero();
    Vec3 SN = Vec3::Zero();

    void Add(double s, double area, const Vec3& areaVector);
    Side Fit(double leastArea) const;
    Side FitLevel(double leastArea) const; ///< without a slope
  };

  const std::vector<Index>& GatherWindow(Index vertex);
  void GatherNear(Index vertex, double radius);
  bool IsBarrier(Index face) const;
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
  const Flags* Barrier = nullptr;
  bool BelieveClose = false;
  std::vector<Index> ClearWindow;
  double Scale = 0.0;
  Vec3 Position;
};
}

#endif
