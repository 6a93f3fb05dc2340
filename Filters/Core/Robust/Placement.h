// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Placement.h
/// Holds the vertices of the region on the faces of their triangles: on one sheet, on the ridge of
/// two, in the corner of three or more.

#ifndef arris_Robust_Placement_h
#define arris_Robust_Placement_h

#include "Core/FreeBoundary.h"
#include "Core/Geometry.h"
#include "Mixed.h"
#include "Ridge.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <memory>

namespace arris
{
/// 1 for an equilateral triangle, 0 for one without area, negative for one that faces away from
/// `expected`, a unit vector.
double ShapeQuality(const Corners& corners, const Vec3& areaVector, const Vec3& expected);
inline double ShapeQuality(const Corners& corners, const Vec3& expected)
{
  return ShapeQuality(corners, corners.AreaVector(), expected);
}

/// The farthest a vertex may be moved, in local scales: farther away no sampling has taken it from;
/// but a blur takes more off an acute edge.
inline double LongestMoveOf(double rounding)
{
  return Mixed(3.25, 4.5, rounding);
}

/// Better than this a triangle need not become.
constexpr double GoodEnoughQuality = 0.15;

class ARRISFILTERS_EXPORT Placement
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
    return this->Sheets[damaged].empty() && !this->Pinned[damaged] && !this->GivenBack[damaged] &&
      !this->Left[damaged];
  }

  /// Lets vertices be moved this far, in local scales.
  void SetReach(double reach) { this->Reach = reach; }

  /// Keeps what an earlier pass has placed, and this one need not, where it is (see Settled.h).
  void SetSettled(Flags settled) { this->SettledVertices = std::move(settled); }
  bool IsSettled(Index vertex) const
  {
    return !this->SettledVertices.empty() && this->SettledVertices[vertex] != 0;
  }

  /// Whether a damaged vertex was put back where it came from.
  bool IsGivenBack(Index vertex) const
  {
    return this->GivenBack[this->TheLabelling.SidesOf[vertex]] != 0;
  }

  bool IsDamaged(Index vertex) const { return this->TheLabelling.SidesOf[vertex] != NoIndex; }

  /// The damaged vertices of triangles, and of those around vertices; ascending.
  std::vector<Index> DamagedOf(const std::vector<Index>& triangles) const;
  std::vector<Index> DamagedAround(const std::vector<Index>& vertices) const
  {
    return this->DamagedOf(TrianglesAround(this->TheConnectivity, vertices));
  }

  const Vec3& PointOf(Index vertex) const { return this->Points[vertex]; }
  void SetPoint(Index vertex, const Vec3& point) { this->Points[vertex] = point; }

  /// The face that a triangle is part of, as its first damaged corner sees it; null if unknown.
  const Sheet* SheetOf(Index triangle) const;

  Index LabelOf(Index triangle) const { return this->FaceLabels[triangle]; }
  void SetLabel(Index triangle, Index label) { this->FaceLabels[triangle] = label; }

  /// Tells which vertices are inside the curves where patches of an assembly meet.
  void SetJunctions(Flags insideJunctions) { this->InsideJunctions = std::move(insideJunctions); }

  /// Keeps the damaged vertices on free boundaries (see FindWalls) in their walls.
  void SetWalls(const std::vector<Wall>& walls);

  bool HasWall(Index vertex) const
  {
    return this->Walls[this->TheLabelling.SidesOf[vertex]] != nullptr;
  }

  /// In how many directions a damaged vertex can be slid while it is held: 2 on a face, 1 on a
  /// ridge or on the boundary of a face, 0 in a corner. Where it is 1, `along` is its direction.
  int Freedom(Index vertex, Vec3& along) const;

  /// Whether a damaged vertex is held on a curve: where two faces meet, or any number of patches
  /// with one face each.
  bool IsOnCurve(Index vertex) const
  {
    return this->OnCurve[this->TheLabelling.SidesOf[vertex]] != 0;
  }

  /// The sheets a damaged vertex is held on; empty where it is not held, and stays.
  const std::vector<const Sheet*>& SheetsOf(Index vertex) const
  {
    return this->Sheets[this->TheLabelling.SidesOf[vertex]];
  }

  /// Finds the sheets of a damaged vertex from the labels around it, and puts it on them.
  void Place(Index vertex);

  /// Whether a damaged vertex is held at a tip.
  bool IsPinned(Index vertex) const
  {
    return this->Pinned[this->TheLabelling.SidesOf[vertex]] != 0;
  }

  /// Whether a vertex may be moved to this point.
  bool IsWithinReach(Index vertex, const Vec3& point) const;

  /// Puts a damaged vertex at a point of these sheets; with none it is given back.
  void Put(Index vertex, const Vec3& point, std::vector<const Sheet*> sheets)
  {
    const Index damaged = this->TheLabelling.SidesOf[vertex];
    this->Points[vertex] = point;
    this->GivenBack[damaged] = sheets.empty() ? 1 : 0;
    this->Left[damaged] = 0;
    this->Sheets[damaged] = std::move(sheets);
  }

  /// Leaves a damaged vertex where it is, until it is placed again.
  void Leave(Index vertex)
  {
    const Index damaged = this->TheLabelling.SidesOf[vertex];
    this->Put(vertex, this->TheMesh.Points[vertex], {});
    this->GivenBack[damaged] = 0;
    this->Left[damaged] = 1;
  }

  /// Takes a vertex over from another placement of the same labelled mesh, but not the labels
  /// around.
  void TakeVertex(Index vertex, const Placement& other);

  /// Puts a damaged vertex where it stays, whatever is placed afterwards: at a tip.
  void Pin(Index vertex, const Vec3& point);

  /// The point on the vertex's sheets next to `target`; the vertex's own where that is too far.
  Vec3 Held(Index vertex, const Vec3& target) const;

  /// Its shape (see ShapeQuality); negative for one that is folded over against the face it is
  /// part of.
  double Quality(Index triangle) const;

  const std::vector<Vec3>& AllPoints() const { return this->Points; }
  std::vector<Vec3> TakePoints() { return std::move(this->Points); }

private:
  struct Meeting
  {
    double Distance;
    Index Label;
    Index Patch; ///< of the assembly
    const Sheet* Surface;
  };

  std::vector<Meeting> MeetingsAt(Index vertex) const;
  void CollectSheets(Index vertex);
  Vec3 OnSheets(Index vertex, const Vec3& start) const;

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Labelling& TheLabelling;
  const std::vector<double>& Scales;
  double Reach = LongestMoveOf(0.0); // in local scales
  std::vector<Index> FaceLabels;
  std::vector<Vec3> Points;
  std::vector<std::vector<const Sheet*>> Sheets;
  Flags Pinned; // of the damaged vertices, as Sheets
  Flags TooFar; // the same
  Flags GivenBack; // the same
  Flags Left; // the same
  Flags OnCurve; // the same
  std::vector<std::shared_ptr<const Sheet>> Walls; // the same; null where there is none
  Flags InsideJunctions; // of all vertices; empty if there are none
  Flags SettledVertices; // the same
};
}

#endif
