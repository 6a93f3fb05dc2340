// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Account.h
/// The account that the robust method gives of itself: what became of each vertex.

#ifndef arris_Robust_Account_h
#define arris_Robust_Account_h

#include "Core/Skeleton.h"

namespace arris
{
class Placement;
struct RobustResult;

/// What became of a vertex. The numbers are those of the Outcome array.
enum class Outcome : unsigned char
{
  Intact = 0, ///< outside the sharp region, and where it was
  Moved = 1, ///< put on the faces around it
  Right = 2, ///< in the sharp region, but on the faces around it already
  NoFace = 3, ///< nothing intact near enough to say where it belongs
  TooFar = 4, ///< farther from where it belongs than sampling takes vertices: left alone
  HeldBack = 5, ///< moved less far or not at all, as a triangle would fold over or cut another
  Smoothed = 6 ///< outside the sharp region, but denoised
};

/// Whether a damaged vertex is not where it belongs, as far as is known.
inline bool IsOutOfPlace(Outcome outcome)
{
  return outcome == Outcome::NoFace || outcome == Outcome::TooFar || outcome == Outcome::HeldBack;
}

/// Brings Roles up to date: who is on the skeleton.
void TellRoles(const Connectivity& connectivity, const Placement& placement, RobustResult& result);

/// Fills Rounds: how far from the intact surface the vertices of the region are.
void TellRounds(const Connectivity& connectivity, RobustResult& result);

/// Brings Outcomes up to date, from where vertices were in the input, and where this pass had them
/// before some had to go back.
void TellOutcomes(const std::vector<Vec3>& input, const std::vector<Vec3>& wanted,
  const Placement& placement, RobustResult& result);
}

#endif
