// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Straighten.h"

#include "Core/Geometry.h"
#include "Core/SortUnique.h"
#include "Creases.h"
#include "MeetSheets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris
{
namespace
{
/// A place is taken if it leaves this share of the creases, or less: not for rounding.
constexpr double Improvement = 0.98;

/// The nearest faces are tried; others hardly matter to a vertex.
constexpr std::size_t MostFaces = 4;

/// Each sweep looks again around what the one before has moved; few move in a third.
constexpr int Sweeps = 4;

/// Twice the area of a triangle over the sum of its squared edges; under this it is a needle.
constexpr double LeastShape = 0.02;

class Straightener
{
public:
  Straightener(const Mesh& mesh, const Connectivity& connectivity, const Labelling& labelling,
    const std::vector<Vec3>& input, Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , TheLabelling(labelling)
    , Input(input)
    , ThePlacement(placement)
  {
  }

  void Run(const std::vector<Index>& damaged)
  {
    std::vector<Index> open = damaged;
    for (int sweep = 0; sweep < Sweeps && !open.empty(); ++sweep)
    {
      std::vector<Index> changed;
      for (Index v : open)
      {
        if (this->Improve(v))
        {
          changed.push_back(v);
        }
      }
      this->Relabel(changed);
      open = this->DamagedAround(changed);
    }
  }

private:
  struct Place
  {
    Vec3 Point;
    std::vector<const Sheet*> Sheets;
  };

  /// Moves v to where the creases around it are least. A corner stays, and a tip: cutting it off
  /// would leave fewer of them, too. So does what is held where patches meet or on a free boundary:
  /// there the faces are known, and creases are not all there is.
  bool Improve(Index v)
  {
    if (this->ThePlacement.IsPinned(v) || this->ThePlacement.IsSettled(v) ||
      this->ThePlacement.SheetsOf(v).size() > 2 || this->IsCommon(v) ||
      this->ThePlacement.HasWall(v))
    {
      return false;
    }
    const Vec3 now = this->ThePlacement.PointOf(v);
    double best = Improvement * this->Creases(v);
    const Place* taken = nullptr;
    this->FindPlaces(v);
    for (const Place& place : this->Places)
    {
      this->ThePlacement.SetPoint(v, place.Point);
      const double creases = this->Creases(v, best);
      if (creases < best && !this->Folds(v, now))
      {
        best = creases;
        taken = &place;
      }
    }
    this->ThePlacement.SetPoint(v, now);
    if (taken != nullptr)
    {
      this->ThePlacement.Put(v, taken->Point, taken->Sheets);
    }
    return taken != nullptr;
  }

  double Creases(Index v, double enough = std::numeric_limits<double>::infinity()) const
  {
    return CreasesAround(
      this->TheMesh.Triangles, this->TheConnectivity, this->ThePlacement.AllPoints(), v, enough);
  }

  /// Whether a triangle at v, which was at `before`, is turned over by the move or left without
  /// area.
  bool Folds(Index v, const Vec3& before) const
  {
    const std::vector<Vec3>& points = this->ThePlacement.AllPoints();
    for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
    {
      const Triangle& c = this->TheMesh.Triangles[t];
      const int k = CornerOf(c, v);
      const Vec3& b = points[c[Next(k)]];
      const Vec3& d = points[c[Next(Next(k))]];
      const Vec3 was = Corners(before, b, d).AreaVector();
      const Vec3 is = Corners(points[v], b, d).AreaVector();
      const double lengths =
        (b - points[v]).squaredNorm() + (d - points[v]).squaredNorm() + (d - b).squaredNorm();
      if (is.dot(was) <= 0.0 || is.norm() < LeastShape * lengths)
      {
        return true;
      }
    }
    return false;
  }

  /// Where it was, and on each, each two and each three of the faces near it.
  void FindPlaces(Index v)
  {
    this->Places.clear();
    const Vec3& x = this->TheMesh.Points[v];
    this->Places.push_back({ x, {} });
    if (this->Input[v] != x)
    {
      this->Places.push_back({ this->Input[v], {} });
    }
    const std::vector<const Sheet*> faces = this->DifferentFaces(v);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      this->AddMeeting(v, { faces[i] });
      for (std::size_t j = i + 1; j < faces.size(); ++j)
      {
        this->AddMeeting(v, { faces[i], faces[j] });
        for (std::size_t k = j + 1; k < faces.size(); ++k)
        {
          this->AddMeeting(v, { faces[i], faces[j], faces[k] });
        }
      }
    }
  }

  /// The nearest faces, one of those with like normals.
  std::vector<const Sheet*> DifferentFaces(Index v) const
  {
    std::vector<const Side*> nearest;
    for (const Side& side : this->TheLabelling.Sides[this->TheLabelling.SidesOf[v]])
    {
      nearest.push_back(&side);
    }
    std::sort(nearest.begin(), nearest.end(),
      [](const Side* a, const Side* b)
      { return a->Distance != b->Distance ? a->Distance < b->Distance : a->Patch < b->Patch; });
    const Vec3& x = this->TheMesh.Points[v];
    std::vector<const Sheet*> faces;
    for (const Side* side : nearest)
    {
      if (faces.size() < MostFaces && !IsSpokenFor(side->Surface, faces, x))
      {
        faces.push_back(&side->Surface);
      }
    }
    return faces;
  }

  void AddMeeting(Index v, std::vector<const Sheet*> sheets)
  {
    const Vec3 point = MeetSheets(this->TheMesh.Points[v], sheets);
    if (this->ThePlacement.IsWithinReach(v, point))
    {
      this->Places.push_back({ point, std::move(sheets) });
    }
  }

  /// Triangles go with the face that their corners now lie on.
  void Relabel(const std::vector<Index>& changed)
  {
    for (Index v : changed)
    {
      for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
      {
        this->RelabelTriangle(t);
      }
    }
  }

  void RelabelTriangle(Index t)
  {
    double least = std::numeric_limits<double>::max();
    for (Index v : this->TheMesh.Triangles[t])
    {
      if (!this->ThePlacement.IsDamaged(v) || this->IsCommon(v))
      {
        continue; // common vertices know faces of other patches, too
      }
      for (const Side& side : this->TheLabelling.Sides[this->TheLabelling.SidesOf[v]])
      {
        const double misfit = this->Misfit(t, side.Surface);
        if (misfit < least)
        {
          least = misfit;
          this->ThePlacement.SetLabel(t, side.Patch);
        }
      }
    }
  }

  /// How far the corners are from a face, and how far the triangle is turned against it.
  double Misfit(Index t, const Sheet& face) const
  {
    const std::vector<Vec3>& points = this->ThePlacement.AllPoints();
    const Corners corners(points, this->TheMesh.Triangles[t]);
    const double turn =
      1.0 - face.Normal(corners.Centroid()).dot(corners.AreaVector().normalized());
    return std::abs(face.Distance(corners.A)) + std::abs(face.Distance(corners.B)) +
      std::abs(face.Distance(corners.C)) + turn * (corners.B - corners.A).norm();
  }

  std::vector<Index> DamagedAround(const std::vector<Index>& vertices) const
  {
    std::vector<Index> around;
    for (Index v : vertices)
    {
      for (Index n : this->TheConnectivity.NeighborsOfVertex[v])
      {
        if (this->ThePlacement.IsDamaged(n))
        {
          around.push_back(n);
        }
      }
      around.push_back(v);
    }
    SortUnique(around);
    return around;
  }

  bool IsCommon(Index v) const
  {
    return !this->TheConnectivity.Common.empty() && this->TheConnectivity.Common[v];
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Labelling& TheLabelling;
  const std::vector<Vec3>& Input;
  Placement& ThePlacement;
  std::vector<Place> Places;
};
}

void Straighten(const Mesh& mesh, const Connectivity& connectivity, const Labelling& labelling,
  const std::vector<Vec3>& input, Placement& placement)
{
  std::vector<Index> damaged;
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (placement.IsDamaged(v))
    {
      damaged.push_back(v);
    }
  }
  Straightener(mesh, connectivity, labelling, input, placement).Run(damaged);
}
}
