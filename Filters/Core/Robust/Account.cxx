// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Account.h"

#include "Core/Flagged.h"
#include "Core/Thinning.h"
#include "Placement.h"
#include "Robust.h"

#include <algorithm>
#include <limits>

namespace arris
{
namespace
{
/// For each vertex of the region how many edges it is away from the intact ones; -1 outside.
std::vector<int> DistancesFromIntact(const Connectivity& connectivity, const Flags& region)
{
  Flags intact(region.size());
  std::transform(region.begin(), region.end(), intact.begin(),
    [](unsigned char damaged) { return static_cast<unsigned char>(damaged ? 0 : 1); });
  std::vector<int> rounds = EdgesAwayFrom(connectivity, intact, std::numeric_limits<int>::max());
  for (std::size_t v = 0; v < rounds.size(); ++v)
  {
    // A part that is damaged all over has no intact vertex to count from.
    rounds[v] = region[v] ? std::max(rounds[v], 1) : NeverSharp;
  }
  return rounds;
}

/// Whether all that was told of a damaged vertex after the pass before still is true.
bool Stays(const Placement& placement, Index v)
{
  return placement.IsDamaged(v) && placement.IsSettled(v) && !placement.IsGivenBack(v);
}

/// The part of a damaged vertex by the number of its ridges' other ends; `roles` has those of the
/// vertices that stay.
SkeletonRole RoleOf(const Connectivity& connectivity, const Placement& placement,
  const std::vector<SkeletonRole>& roles, Index v)
{
  const std::size_t faces = placement.SheetsOf(v).size();
  if (faces < 2)
  {
    return SkeletonRole::None;
  }
  if (faces > 2 && !placement.IsOnCurve(v))
  {
    return SkeletonRole::Joint;
  }
  const IndexSpan neighbors = connectivity.NeighborsOfVertex[v];
  const auto ridges = std::count_if(neighbors.begin(), neighbors.end(),
    [&](Index n)
    {
      return Stays(placement, n) ? roles[n] != SkeletonRole::None
                                 : placement.IsDamaged(n) && placement.SheetsOf(n).size() > 1;
    });
  return ridges > 1 ? SkeletonRole::Branch : SkeletonRole::End;
}

Outcome OutcomeOf(Index v, const Vec3& input, const Vec3& wanted, const Placement& placement)
{
  const Vec3& now = placement.PointOf(v);
  if (!placement.IsDamaged(v))
  {
    return now != wanted ? Outcome::HeldBack : (now != input ? Outcome::Smoothed : Outcome::Intact);
  }
  if (placement.IsGivenBack(v))
  {
    return Outcome::HeldBack;
  }
  if (placement.IsTooFar(v))
  {
    return Outcome::TooFar;
  }
  if (placement.IsLost(v))
  {
    return Outcome::NoFace;
  }
  return now != wanted ? Outcome::HeldBack : (now != input ? Outcome::Moved : Outcome::Right);
}
}

void TellRoles(const Connectivity& connectivity, const Placement& placement, RobustResult& result)
{
  result.Roles.resize(result.Region.size(), SkeletonRole::None);
  for (std::size_t v = 0; v < result.Region.size(); ++v)
  {
    const Index vertex = static_cast<Index>(v);
    if (!placement.IsDamaged(vertex))
    {
      result.Roles[v] = SkeletonRole::None;
    }
    else if (!Stays(placement, vertex))
    {
      result.Roles[v] = RoleOf(connectivity, placement, result.Roles, vertex);
    }
  }
}

void TellRounds(const Connectivity& connectivity, RobustResult& result)
{
  result.Rounds = DistancesFromIntact(connectivity, result.Region);
  const int last =
    result.Rounds.empty() ? 0 : *std::max_element(result.Rounds.begin(), result.Rounds.end());
  for (std::size_t v = 0; v < result.Region.size(); ++v)
  {
    if (result.Roles[v] != SkeletonRole::None)
    {
      result.Rounds[v] = last + 1;
    }
  }
}

void TellOutcomes(const std::vector<Vec3>& input, const std::vector<Vec3>& wanted,
  const Placement& placement, RobustResult& result)
{
  for (std::size_t v = 0; v < input.size(); ++v)
  {
    const Index vertex = static_cast<Index>(v);
    const bool untouched = Stays(placement, vertex)
      ? placement.PointOf(vertex) == wanted[v]
      : !placement.IsDamaged(vertex) && result.Outcomes[v] != Outcome::Intact;
    if (!untouched) // by this pass; what an earlier one has done stands
    {
      result.Outcomes[v] = OutcomeOf(vertex, input[v], wanted[v], placement);
    }
  }
}
}
