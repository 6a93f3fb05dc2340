// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Sides.h
/// The smooth faces around a damaged vertex, carried on to it, and which of them it belongs to.

#ifndef arris_Robust_Sides_h
#define arris_Robust_Sides_h

#include "Core/Assembly/PatchesApart.h"
#include "LocalSolid.h"
#include "NearVertices.h"
#include "Patches.h"
#include "Region.h"

namespace arris
{
/// All that is known of the mesh before sides are fitted.
struct Surroundings
{
  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Faces& TheFaces;
  const std::vector<double>& Scales;
  const std::vector<double>& Flatness; ///< λτ of each vertex
  double Rounding; ///< how far the sampling has rounded edges, 0 to 1
  Roughness Rough; ///< of the input
  const Whole* Together; ///< the assembly that this is the patches of; null for one 2-manifold

  /// Whether a blur has rounded all edges. Noise leaves too little of its shape to tell its width.
  bool IsBlurred() const { return this->Rounding > BlurRounding && this->Rough.Noise == 0.0; }
};

/// λτ at which a sample's weight falls to 1/e: what bends is contaminated or another face.
constexpr double FlatnessScale = 0.2;

/// What sides are fitted to.
struct Samples
{
  const std::vector<Vec3>& Points;
  const std::vector<Vec3>& Normals;
  const std::vector<double>& Flatness; ///< λτ of each vertex: the more, the less it counts
  const Flags& Region; ///< without the vertices in here
  const Patches& ThePatches;
  double BlurWidth; ///< of a blur that has been undone, in local scales; else 0
};

/// One of the faces around a vertex.
struct Side
{
  Index Patch;
  Sheet Surface;
  double Distance; ///< from the vertex to the nearest sample
  double Cost; ///< how ill the vertex fits this face: small for the one it lies on
};

/// Finds the sides of vertices. Keeps its working memory: use one object a thread.
class SideFinder
{
public:
  SideFinder(const Surroundings& around, const Samples& samples)
    : Around(around)
    , From(samples)
  {
  }

  /// How far away samples are taken, in local scales.
  static double Reach(const Surroundings& around);

  /// The sides of vertices near each other, the first in their middle: fitted there, and for each
  /// vertex how well it fits them. `sides` has one row for each vertex. Returns the solid that the
  /// sides bound.
  LocalSolid Find(IndexSpan vertices, const std::vector<std::vector<Side>*>& sides);

private:
  /// How far away faces are looked for, in local scales.
  static double PatchReach(const Surroundings& around);

  struct NearVertex
  {
    double Distance;
    Index Vertex;
    bool operator<(const NearVertex& other) const
    {
      return this->Distance != other.Distance ? this->Distance < other.Distance
                                              : this->Vertex < other.Vertex;
    }
  };
  /// How far away samples are taken, and how fast they count for less.
  struct FitWindow
  {
    double Radius;
    double Width;
  };

  /// Fits the sides around a vertex and tells how they meet.
  std::vector<Side> FitAround(Index vertex, LocalSolid& solid);
  void GatherStatic(Index vertex, double radius);
  void GatherBeyond(Index vertex, double radius);
  void Fit(Index vertex, Side& side);
  FitWindow WindowFrom(double nearest, double scale) const;
  SheetSample SampleAt(const NearVertex& near, double width) const;

  /// Fits a side to all that may be of its face, if one sheet suits it.
  void FitWider(double scale, const SheetCaution& caution, Sheet& own);

  /// Fits a side to its continuations in other patches as well.
  void FitBeyond(double scale, const SheetCaution& caution, Sheet& own) const;

  const Surroundings& Around;
  const Samples& From;
  NearVertices Near;
  std::vector<NearVertex> Static; ///< the intact ones, nearest first
  std::vector<std::vector<NearVertex>> Beyond; ///< those of an assembly's other patches, by piece
  std::vector<SheetSample> Fitted;
  std::vector<SheetSample> Wider; // that may be of the same face, if it is tightly curved
};
}

#endif
