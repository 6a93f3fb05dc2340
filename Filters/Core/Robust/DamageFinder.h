// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file DamageFinder.h
/// The damaged vertices, pass after pass: the first three steps of the method.

#ifndef arris_Robust_DamageFinder_h
#define arris_Robust_DamageFinder_h

#include "Core/Assembly/PatchesApart.h"
#include "Region.h"
#include "Robust.h"

namespace arris
{
/// Finds the damaged vertices of a mesh, pass after pass.
class DamageFinder
{
public:
  /// Refers to all that it is given.
  DamageFinder(const Connectivity& connectivity, const std::vector<double>& localScales,
    const RobustParameters& parameters, const Roughness& rough, const Whole* together);

  /// Finds the region of `mesh`. What an earlier pass has found damaged, `before`, stays so, even
  /// where a shallow edge shows less now: a gap would join the faces on its two sides. `moved` are
  /// the vertices that have moved since then. False if the monitor stopped it.
  bool Find(const Mesh& mesh, const Faces& faces, const Flags& before, const Flags& moved,
    const Monitor& monitor);

  Flags Region;
  double Rounding = 0.0; ///< of the first pass: 0 where edges were cut off, 1 where rounded as well
  EdgeAngles Angles;

  /// What the last pass has measured at each vertex.
  void TellTurns(RobustResult& result) const;

private:
  bool MeasureTurns(
    const Mesh& mesh, const Faces& faces, const Flags& moved, const Monitor& monitor);

  const Connectivity& TheConnectivity;
  const Roughness& Rough;
  const Whole* Together; ///< null for one 2-manifold
  const std::vector<double>& LocalScales;
  std::vector<double> Scales; ///< as the user wants them
  std::vector<Turn> Turns;
};
}

#endif
