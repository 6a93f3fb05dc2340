// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Robust.h
/// The robust method from end to end: no parameters, faces carried on with their curvature, nothing
/// folded and nothing cut.
///
/// First the mesh is put in a frame and an order of its own (OwnMesh), at last what was moved is
/// put back.
///
///  0. Roughness, Denoised: what is rough is worked on in a smooth copy.
///  1. Turn: at each vertex, the turn that is left once both sides are extrapolated to it.
///  2. DamageFinder, Region: where that turn is concentrated, an edge was sampled away; where edges
///     meet, the turn is taken without the other edge. FineBends: bends that are meant are left
///     alone.
///  3. ThinFaces, Patches: the intact vertices around, sorted into faces.
///  4. Sheet, Sides: each face carried on to each damaged vertex, as a plane or a torus.
///  5. Unexplained: vertices far from all of these are a narrow face's own.
///  6. LocalSolid, Labels: which face a vertex lies on, as faces cut and join each other.
///  7. Ridge: the fewest vertices that separate the faces; these are the skeleton.
///  8. Placement, MeetSheets: each vertex put on the faces around it.
///  9. Mending: Untangle, Straighten, Retreat: folded triangles mended, notches straightened, what
///     cannot be mended taken back. OtherOrders: the best of several tries. GiveBack: not what was
///     better before.
///
/// Then once more from the first step on what came out; Settled: but only around what that shows.

#ifndef arris_Robust_Robust_h
#define arris_Robust_Robust_h

#include "Account.h"
#include "Core/Parallel.h"
#include "Roughness.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// What the user may set; by default the mesh decides.
struct RobustParameters
{
  double WindowRadius = 0.0; ///< λ; 0: three quarters of the local edge length
  double SharpAngle = 0.0; ///< degrees; the turn from which on an edge is sharp; 0: 16, of
                           ///< segmentations 13, of noise 22
  bool Denoise = false; ///< of a rough mesh, the smooth faces are moved as well
  bool AllowEdgeFlips = false; ///< see EdgeFlips.h; not of assemblies
};

struct RobustResult
{
  Roughness Rough;
  double Rounding = 0.0; ///< 0: edges were cut off, 1: they were rounded as well
  double BendTriangleSize = 1.0; ///< see FineBends.h; 1 where edges are neither rough nor rounded
  bool BendsAreMeant = false; ///< and so left alone
  double SharpAngle = 0.0; ///< degrees; as set, or as chosen
  std::vector<double> WindowRadii; ///< λ of each vertex: follows the local edge length
  std::vector<double> NormalDifferences; ///< λτ of each vertex in that window
  std::vector<double> Jumps; ///< the turn between the faces beside each vertex, in degrees
  Flags Region; ///< the sharp region Ω
  std::vector<int> Rounds; ///< -1 outside Ω, then the distance from there in edges;
                           ///< the skeleton has the largest value
  std::vector<SkeletonRole> Roles;
  std::vector<Outcome> Outcomes;
  std::vector<Vec3> Points;
  Index EdgeFlips = 0; ///< how many edges were flipped
  std::vector<Triangle> Triangles; ///< all as they are then; empty if none was flipped

  // What finding the region, the skeleton and the positions took.
  double ClassificationSeconds = 0.0;
  double ThinningSeconds = 0.0;
  double SharpeningSeconds = 0.0;
};

/// Recovers the sharp edges of a mesh. The result has no points if the monitor stopped it.
ARRISFILTERS_EXPORT RobustResult RecoverRobustly(const Mesh& mesh, const Connectivity& connectivity,
  const RobustParameters& parameters, const Monitor& monitor);
}

#endif
