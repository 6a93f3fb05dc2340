// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Placement.h"

#include "Core/Geometry.h"
#include "Core/SortUnique.h"
#include "MeetSheets.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace arris
{
namespace
{
/// A vertex this near to its faces is right already, and keeps every bit; in local scales.
constexpr double LeastMove = 0.003;
}

Placement::Placement(const Mesh& mesh, const Connectivity& connectivity, const Labelling& labelling,
  const std::vector<double>& scales, std::vector<Index> faceLabels)
  : TheMesh(mesh)
  , TheConnectivity(connectivity)
  , TheLabelling(labelling)
  , Scales(scales)
  , FaceLabels(std::move(faceLabels))
  , Points(mesh.Points)
  , Sheets(labelling.Sides.size())
  , Pinned(labelling.Sides.size(), 0)
  , TooFar(labelling.Sides.size(), 0)
  , GivenBack(labelling.Sides.size(), 0)
  , Left(labelling.Sides.size(), 0)
  , OnCurve(labelling.Sides.size(), 0)
  , Walls(labelling.Sides.size())
{
}

std::vector<Index> Placement::DamagedOf(const std::vector<Index>& triangles) const
{
  std::vector<Index> vertices;
  for (Index t : triangles)
  {
    const Triangle& corners = this->TheMesh.Triangles[t];
    std::copy_if(corners.begin(), corners.end(), std::back_inserter(vertices),
      [this](Index v) { return this->IsDamaged(v); });
  }
  SortUnique(vertices);
  return vertices;
}

std::vector<Placement::Meeting> Placement::MeetingsAt(Index vertex) const
{
  const std::vector<Index>& patchOf = this->TheConnectivity.PatchOf;
  std::vector<Meeting> meetings;
  for (Index t : this->TheConnectivity.TrianglesOfVertex[vertex])
  {
    const Index label = this->FaceLabels[t];
    const bool known = std::any_of(meetings.begin(), meetings.end(),
      [label](const Meeting& meeting) { return meeting.Label == label; });
    if (label == NoIndex || known)
    {
      continue;
    }
    if (const Sheet* sheet = this->TheLabelling.SheetAt(this->TheConnectivity, vertex, label))
    {
      const Side* side =
        FindSide(this->TheLabelling.Sides[this->TheLabelling.SidesOf[vertex]], label);
      meetings.push_back(
        { side ? side->Distance : 1e30, label, patchOf.empty() ? 0 : patchOf[t], sheet });
    }
  }
  std::sort(meetings.begin(), meetings.end(),
    [](const Meeting& a, const Meeting& b)
    { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Label < b.Label; });
  return meetings;
}

void Placement::CollectSheets(Index vertex)
{
  const std::vector<Meeting> meetings = this->MeetingsAt(vertex);
  // Of faces with like normals the nearest speaks for all; patches may look either way.
  const double like = std::cos(LeastCrossingAngle * Pi / 180.0);
  const Vec3& x = this->TheMesh.Points[vertex];
  const auto isLike = [&](const Meeting& a, const Meeting& b)
  {
    const double cosine = a.Surface->Normal(x).dot(b.Surface->Normal(x));
    return (a.Patch == b.Patch ? cosine : std::abs(cosine)) > like;
  };
  const Index damaged = this->TheLabelling.SidesOf[vertex];
  std::vector<const Sheet*>& sheets = this->Sheets[damaged];
  sheets.clear();
  std::vector<const Meeting*> kept;
  for (const Meeting& meeting : meetings)
  {
    const bool spokenFor = std::any_of(
      kept.begin(), kept.end(), [&](const Meeting* other) { return isLike(*other, meeting); });
    if (!spokenFor)
    {
      kept.push_back(&meeting);
      sheets.push_back(meeting.Surface);
    }
  }
  // All faces count here, also one of this patch that one of another has spoken for.
  const auto onePerPatch = [&]
  {
    return std::all_of(meetings.begin(), meetings.end(),
      [&](const Meeting& a)
      {
        return std::all_of(meetings.begin(), meetings.end(),
          [&](const Meeting& b) { return a.Patch != b.Patch || isLike(a, b); });
      });
  };
  const bool insideJunction = !this->InsideJunctions.empty() && this->InsideJunctions[vertex];
  this->OnCurve[damaged] =
    sheets.size() == 2 || (sheets.size() > 2 && insideJunction && onePerPatch());
}

Vec3 Placement::OnSheets(Index vertex, const Vec3& start) const
{
  const std::vector<const Sheet*>& sheets = this->SheetsOf(vertex);
  if (const Sheet* wall = this->Walls[this->TheLabelling.SidesOf[vertex]].get())
  {
    std::vector<const Sheet*> all = sheets;
    all.push_back(wall);
    return MeetSheets(start, all);
  }
  return MeetSheets(start, sheets, sheets.size() > 2 && this->IsOnCurve(vertex) ? 2 : 3);
}

void Placement::SetWalls(const std::vector<Wall>& walls)
{
  for (std::size_t v = 0; v < walls.size(); ++v)
  {
    const Index damaged = this->TheLabelling.SidesOf[v];
    if (damaged == NoIndex)
    {
      continue;
    }
    const Vec3& x = this->TheMesh.Points[v];
    if (walls[v].Fixed)
    {
      this->Pin(static_cast<Index>(v), x);
    }
    else if (!walls[v].Normal.isZero(0.0))
    {
      this->Walls[damaged] = std::make_shared<const Sheet>(x, walls[v].Normal);
    }
  }
}

int Placement::Freedom(Index vertex, Vec3& along) const
{
  const std::vector<const Sheet*>& sheets = this->SheetsOf(vertex);
  const Sheet* wall = this->Walls[this->TheLabelling.SidesOf[vertex]].get();
  if (sheets.empty() || (sheets.size() > 1 && (wall || !this->IsOnCurve(vertex))))
  {
    return 0;
  }
  const Sheet* second = sheets.size() > 1 ? sheets[1] : wall;
  if (second == nullptr)
  {
    return 2;
  }
  const Vec3& point = this->PointOf(vertex);
  along = sheets[0]->Normal(point).cross(second->Normal(point)).normalized();
  return 1;
}

void Placement::Pin(Index vertex, const Vec3& point)
{
  const Index damaged = this->TheLabelling.SidesOf[vertex];
  this->Pinned[damaged] = 1;
  this->Sheets[damaged].clear();
  this->Points[vertex] = point;
}

void Placement::TakeVertex(Index vertex, const Placement& other)
{
  this->Points[vertex] = other.Points[vertex];
  const Index damaged = this->TheLabelling.SidesOf[vertex];
  if (damaged != NoIndex)
  {
    this->Sheets[damaged] = other.Sheets[damaged];
    this->TooFar[damaged] = other.TooFar[damaged];
    this->GivenBack[damaged] = other.GivenBack[damaged];
    this->Left[damaged] = other.Left[damaged];
    this->OnCurve[damaged] = other.OnCurve[damaged];
  }
}

void Placement::Place(Index vertex)
{
  const Index damaged = this->TheLabelling.SidesOf[vertex];
  if (this->Pinned[damaged] || this->IsSettled(vertex))
  {
    return;
  }
  std::vector<const Sheet*>& sheets = this->Sheets[damaged];
  this->CollectSheets(vertex);
  const Vec3& x = this->TheMesh.Points[vertex];
  this->Points[vertex] = x;
  this->TooFar[damaged] = 0;
  this->GivenBack[damaged] = 0;
  this->Left[damaged] = 0;
  if (!sheets.empty())
  {
    const Vec3 point = this->OnSheets(vertex, x);
    const double move = (point - x).norm() / this->Scales[vertex];
    if (move > this->Reach)
    {
      sheets.clear();
      this->TooFar[damaged] = 1;
    }
    else if (move > LeastMove)
    {
      this->Points[vertex] = point;
    }
  }
}

bool Placement::IsWithinReach(Index vertex, const Vec3& point) const
{
  return (point - this->TheMesh.Points[vertex]).norm() <= this->Reach * this->Scales[vertex];
}

Vec3 Placement::Held(Index vertex, const Vec3& target) const
{
  const Vec3 point = this->OnSheets(vertex, target);
  return this->IsWithinReach(vertex, point) ? point : this->Points[vertex];
}

const Sheet* Placement::SheetOf(Index triangle) const
{
  for (Index v : this->TheMesh.Triangles[triangle])
  {
    const Sheet* sheet = this->IsDamaged(v)
      ? this->TheLabelling.SheetAt(this->TheConnectivity, v, this->FaceLabels[triangle])
      : nullptr;
    if (sheet != nullptr)
    {
      return sheet;
    }
  }
  return nullptr;
}

double ShapeQuality(const Corners& corners, const Vec3& areaVector, const Vec3& expected)
{
  constexpr double Equilateral = 3.4641016151377544; // 2 sqrt(3)
  const double lengths = (corners.B - corners.A).squaredNorm() +
    (corners.C - corners.B).squaredNorm() + (corners.A - corners.C).squaredNorm();
  return lengths > 0.0 ? Equilateral * areaVector.dot(expected) / lengths : 0.0;
}

double Placement::Quality(Index t) const
{
  const Corners corners(this->Points, this->TheMesh.Triangles[t]);
  const Sheet* sheet = this->SheetOf(t);
  const Vec3 expected = sheet ? sheet->Normal(corners.Centroid())
                              : Vec3(Corners(this->TheMesh, t).AreaVector().normalized());
  return ShapeQuality(corners, expected);
}
}
