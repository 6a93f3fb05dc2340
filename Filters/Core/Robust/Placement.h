// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Placement.h
/// Holds the vertices of the region on the faces of their triangles: on one sheet, on the ridge of
/// two, in the corner of three or more.

#ifndef arris_Robust_Placement_h
#define arris_Robust_Placement_h

#include "Core/Geometry.h"
#include "Ridge.h"

namespace arris
{
/// 1 for an equilateral triangle, 0 for one without area, negative for one that faces away from
/// `expected`, a unit vector.
double ShapeQuality(const Corners& corners, const Vec3& expected);

class Placement
{
public:
  Placement(const Mesh& mesh, const Connectivity& connectivity, const Labelling& labelling,
    const std::vector<double>& scales, std::vector<Index> faceLabels);

  /// Whether a damaged vertex belongs farther away than it may be moved, or no face tells where.
  bool IsTooFar(Index vertex) const
  {
    return this->TooFar[this->TheLabelling.SidesOf[vertex]] != 0;
  }
  bool IsLost(Index vertex) const
  {
    const Index damaged = this->TheLabelling.SidesOf[vertex];
    return this->Sheets[damaged].empty() && !this->Pinned[damaged];
  }

  bool IsDamaged(Index vertex) const { return this->TheLabelling.SidesOf[vertex] != NoIndex; }

  const Vec3& PointOf(Index vertex) const { return this->Points[vertex]; }
  void SetPoint(Index vertex, const Vec3& point) { this->Points[vertex] = point; }

  Index LabelOf(Index triangle) const { return this->FaceLabels[triangle]; }
  void SetLabel(Index triangle, Index label) { this->FaceLabels[triangle] = label; }

  /// The sheets a damaged vertex is held on; empty where it is not held, and stays.
  const std::vector<const Sheet*>& SheetsOf(Index vertex) const
  {
    return this->Sheets[this->TheLabelling.SidesOf[vertex]];
  }

  /// Finds the sheets of a damaged vertex from the labels around it, and puts it on them.
  void Place(Index vertex);

  /// Puts a damaged vertex where it stays, whatever is placed afterwards: at a tip.
  void Pin(Index vertex, const Vec3& point);

  /// The point on the vertex's sheets next to `target`; the vertex's own where that is too far.
  Vec3 Held(Index vertex, const Vec3& target) const;

  /// 1 for an equilateral triangle, 0 for one without area, negative for one that is folded over
  /// against the face it is part of.
  double Quality(Index triangle) const;

  const std::vector<Vec3>& AllPoints() const { return this->Points; }
  std::vector<Vec3> TakePoints() { return std::move(this->Points); }

private:
  void CollectSheets(Index vertex, std::vector<const Sheet*>& sheets) const;

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Labelling& TheLabelling;
  const std::vector<double>& Scales;
  std::vector<Index> FaceLabels;
  std::vector<Vec3> Points;
  std::vector<std::vector<const Sheet*>> Sheets;
  Flags Pinned; // of the damaged vertices, as Sheets
  Flags TooFar; // the same
};
}

#endif
