// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Picks.h
/// The window and the threshold that picked points ask for (section 4.2, last paragraph).

#ifndef arris_Picks_h
#define arris_Picks_h

#include "Mesh.h"
#include "Ussod.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The vertices that a picked point or cell stands for; the sharpest of them counts.
using Pick = std::vector<Index>;

struct Picks
{
  std::vector<Pick> Sharp; ///< expected to be in the sharp region
  std::vector<Pick> Smooth; ///< expected not to be

  bool empty() const { return this->Sharp.empty() && this->Smooth.empty(); }
};

/// What tells sharp vertices from smooth ones: the paper's λ, κ and how windows are searched.
struct ClassificationParameters
{
  double WindowRadius; ///< λ, in units of length
  double SharpAngle; ///< θ with κλ = 1 - cos θ, degrees
  WindowSearch Search;
};

/// Window radii that are tried for sharp picks, in average edge lengths: from the paper's least on,
/// in steps that no user would tell apart, to the 2 that rounded edges need (the paper ends
/// at 1.5).
constexpr double LeastPickedRatio = 0.5;
constexpr double PickedRatioStep = 0.05;
constexpr int PickedRatioSteps = 30;

/// Where even the largest window's normals deviate by less than this, in degrees, nothing is sharp;
/// and by so much must sharp and smooth picks differ, or rounding would tell them apart.
constexpr double LeastPickedAngle = 1.0;

enum class PickVerdict
{
  Followed,
  Contradictory, ///< a smooth pick is no smoother than a sharp one, whatever the window
  NotSharp ///< the surface is flat around a sharp pick
};

struct FollowedPicks
{
  PickVerdict Verdict = PickVerdict::Followed;
  ClassificationParameters Parameters; ///< if followed

  /// The sharp pick of least and the smooth pick of greatest normal deviation (degrees) in the
  /// window chosen or, of contradictory picks, in the one that was wanted.
  std::size_t Sharp = 0;
  std::size_t Smooth = 0;
  double SharpDeviation = 0.0;
  double SmoothDeviation = 0.0;
};

/// The parameters by which all sharp picks are classified sharp and all smooth ones smooth.
///
/// With sharp picks the window grows from half the average edge length on until all of them reach
/// `wanted.SharpAngle`; the threshold κ is then the least τ of them. If no window makes them so
/// sharp, the smallest takes its place in which the least sharp one is about as sharp as it gets.
/// Windows in which a smooth pick is not smoother than a sharp one are passed over. With smooth
/// picks only, the window shrinks from `wanted.WindowRadius` until none reaches the angle, and if
/// that is not enough, the angle rises above them.
ARRISFILTERS_EXPORT FollowedPicks FollowPicks(const Mesh& mesh, const Connectivity& connectivity,
  double averageEdgeLength, const Picks& picks, const ClassificationParameters& wanted);
}

#endif
