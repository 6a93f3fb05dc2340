// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Placement.h"

#include "Core/Geometry.h"
#include "MeetSheets.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
/// The farthest a vertex may be moved, in local scales: farther away no sampling has taken it from.
constexpr double LongestMove = 3.25;

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
{
}

void Placement::CollectSheets(Index vertex, std::vector<const Sheet*>& sheets) const
{
  struct Meeting
  {
    double Distance;
    Index Label;
    const Sheet* Surface;
  };
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
      meetings.push_back({ side ? side->Distance : 1e30, label, sheet });
    }
  }
  std::sort(meetings.begin(), meetings.end(),
    [](const Meeting& a, const Meeting& b)
    { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Label < b.Label; });
  // Of faces with like normals the nearest speaks for all.
  const Vec3& x = this->TheMesh.Points[vertex];
  sheets.clear();
  for (const Meeting& meeting : meetings)
  {
    if (!IsSpokenFor(*meeting.Surface, sheets, x))
    {
      sheets.push_back(meeting.Surface);
    }
  }
}

void Placement::Pin(Index vertex, const Vec3& point)
{
  const Index damaged = this->TheLabelling.SidesOf[vertex];
  this->Pinned[damaged] = 1;
  this->Sheets[damaged].clear();
  this->Points[vertex] = point;
}

void Placement::Place(Index vertex)
{
  if (this->Pinned[this->TheLabelling.SidesOf[vertex]])
  {
    return;
  }
  std::vector<const Sheet*>& sheets = this->Sheets[this->TheLabelling.SidesOf[vertex]];
  this->CollectSheets(vertex, sheets);
  const Vec3& x = this->TheMesh.Points[vertex];
  this->Points[vertex] = x;
  this->TooFar[this->TheLabelling.SidesOf[vertex]] = 0;
  this->GivenBack[this->TheLabelling.SidesOf[vertex]] = 0;
  if (!sheets.empty())
  {
    const Vec3 point = MeetSheets(x, sheets);
    const double move = (point - x).norm() / this->Scales[vertex];
    if (move > LongestMove)
    {
      sheets.clear();
      this->TooFar[this->TheLabelling.SidesOf[vertex]] = 1;
    }
    else if (move > LeastMove)
    {
      this->Points[vertex] = point;
    }
  }
}

bool Placement::IsWithinReach(Index vertex, const Vec3& point) const
{
  return (point - this->TheMesh.Points[vertex]).norm() <= LongestMove * this->Scales[vertex];
}

Vec3 Placement::Held(Index vertex, const Vec3& target) const
{
  const Vec3 point = MeetSheets(target, this->SheetsOf(vertex));
  return this->IsWithinReach(vertex, point) ? point : this->Points[vertex];
}

double Placement::Quality(Index t) const
{
  const Triangle& c = this->TheMesh.Triangles[t];
  const Corners corners(this->Points[c[0]], this->Points[c[1]], this->Points[c[2]]);
  const double lengths = (corners.B - corners.A).squaredNorm() +
    (corners.C - corners.B).squaredNorm() + (corners.A - corners.C).squaredNorm();
  if (!(lengths > 0.0))
  {
    return 0.0;
  }
  const Sheet* sheet = nullptr;
  for (int k = 0; k < 3 && sheet == nullptr; ++k)
  {
    if (this->IsDamaged(c[k]))
    {
      sheet = this->TheLabelling.SheetAt(this->TheConnectivity, c[k], this->FaceLabels[t]);
    }
  }
  const Vec3 expected = sheet ? sheet->Normal(corners.Centroid())
                              : Vec3(Corners(this->TheMesh, t).AreaVector().normalized());
  constexpr double Equilateral = 3.4641016151377544; // 2 sqrt(3)
  return Equilateral * corners.AreaVector().dot(expected) / lengths;
}
}
