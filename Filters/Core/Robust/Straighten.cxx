// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Straighten.h"

#include "Core/Flagged.h"
#include "Core/Geometry.h"
#include "Core/Parallel.h"
#include "Creases.h"
#include "MeetSheets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

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

constexpr double Unlimited = std::numeric_limits<double>::infinity();

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
    , ColourOf(mesh.Points.size(), NoIndex)
  {
  }

  void Run(const std::vector<Index>& damaged)
  {
    std::vector<Index> open = damaged;
    for (int sweep = 0; sweep < Sweeps && !open.empty(); ++sweep)
    {
      const std::vector<Index> changed = this->Sweep(open);
      this->Relabel(changed);
      open = this->ThePlacement.DamagedAround(changed);
    }
  }

private:
  struct Place
  {
    Vec3 Point;
    std::vector<const Sheet*> Sheets;
  };

  /// Puts vertices to better places, colour after colour. Returns those that had one, ascending.
  std::vector<Index> Sweep(const std::vector<Index>& open)
  {
    Flags hasChanged(open.size(), 0);
    for (const std::vector<Index>& colour : this->SortIntoColours(open))
    {
      ParallelFor(static_cast<Index>(colour.size()),
        [&](Index begin, Index end)
        {
          for (Index i = begin; i < end; ++i)
          {
            hasChanged[colour[i]] = this->Improve(open[colour[i]]) ? 1 : 0;
          }
        });
    }
    std::vector<Index> changed;
    for (Index i : Flagged(hasChanged))
    {
      changed.push_back(open[i]);
    }
    return changed;
  }

  /// Sorts places of vertices in `open` so that of one colour none has a part in the creases of
  /// another: these can be improved at the same time.
  std::vector<std::vector<Index>> SortIntoColours(const std::vector<Index>& open)
  {
    std::vector<std::vector<Index>> colours;
    Flags taken;
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      taken.assign(colours.size() + 1, 0);
      this->ForEachInCreases(open[i],
        [&](Index n)
        {
          if (this->ColourOf[n] != NoIndex)
          {
            taken[this->ColourOf[n]] = 1;
          }
        });
      const Index colour =
        static_cast<Index>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
      colours.resize(std::max<std::size_t>(colours.size(), colour + 1));
      colours[colour].push_back(static_cast<Index>(i));
      this->ColourOf[open[i]] = colour;
    }
    for (Index v : open)
    {
      this->ColourOf[v] = NoIndex; // for the next sweep
    }
    return colours;
  }

  /// Calls visit(vertex) for all others whose places have a part in the creases around one, or the
  /// other way round: an edge of several patches is walked around to the end.
  template <typename Visit>
  void ForEachInCreases(Index v, Visit&& visit)
  {
    for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
    {
      for (int k = 0; k < 3; ++k)
      {
        RingOfEdge(this->TheMesh, this->TheConnectivity, t, k, this->Ring);
        for (Index at : this->Ring)
        {
          for (Index n : this->TheMesh.Triangles[at])
          {
            if (n != v)
            {
              visit(n);
            }
          }
        }
      }
    }
  }

  /// Moves a vertex to its better place, if it has one.
  bool Improve(Index v)
  {
    std::optional<Place> place = this->BetterPlace(v);
    if (place)
    {
      this->ThePlacement.Put(v, place->Point, std::move(place->Sheets));
    }
    return place.has_value();
  }

  /// Where the creases around a vertex are least. A corner stays, and a tip: cutting it off
  /// would leave fewer of them, too. So does what is held where patches meet or on a free boundary:
  /// there the faces are known, and creases are not all there is.
  std::optional<Place> BetterPlace(Index v) const
  {
    if (this->ThePlacement.IsPinned(v) || this->ThePlacement.IsSettled(v) ||
      this->ThePlacement.SheetsOf(v).size() > 2 || this->IsCommon(v) ||
      this->ThePlacement.HasWall(v))
    {
      return std::nullopt;
    }
    double best = Improvement * this->Creases(v, this->ThePlacement.PointOf(v), Unlimited);
    std::optional<Place> better;
    for (Place& place : this->PlacesFor(v))
    {
      const double creases = this->Creases(v, place.Point, best);
      if (creases < best && !this->Folds(v, place.Point))
      {
        best = creases;
        better = std::move(place);
      }
    }
    return better;
  }

  double Creases(Index v, const Vec3& at, double enough) const
  {
    return CreasesAround(this->TheMesh.Triangles, this->TheConnectivity,
      this->ThePlacement.AllPoints(), v, at, enough);
  }

  /// Whether a triangle at v would be turned over by a move or left without area.
  bool Folds(Index v, const Vec3& to) const
  {
    const std::vector<Vec3>& points = this->ThePlacement.AllPoints();
    for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
    {
      const Triangle& c = this->TheMesh.Triangles[t];
      const int k = CornerOf(c, v);
      const Vec3& b = points[c[Next(k)]];
      const Vec3& d = points[c[Next(Next(k))]];
      const Vec3 was = Corners(points[v], b, d).AreaVector();
      const Vec3 is = Corners(to, b, d).AreaVector();
      const double lengths =
        (b - to).squaredNorm() + (d - to).squaredNorm() + (d - b).squaredNorm();
      if (is.dot(was) <= 0.0 || is.norm() < LeastShape * lengths)
      {
        return true;
      }
    }
    return false;
  }

  /// Where it was, and on each, each two and each three of the faces near it.
  std::vector<Place> PlacesFor(Index v) const
  {
    std::vector<Place> places;
    const Vec3& x = this->TheMesh.Points[v];
    places.push_back({ x, {} });
    if (this->Input[v] != x)
    {
      places.push_back({ this->Input[v], {} });
    }
    const std::vector<const Sheet*> faces = this->DifferentFaces(v);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      this->AddMeeting(v, places, { faces[i] });
      for (std::size_t j = i + 1; j < faces.size(); ++j)
      {
        this->AddMeeting(v, places, { faces[i], faces[j] });
        for (std::size_t k = j + 1; k < faces.size(); ++k)
        {
          this->AddMeeting(v, places, { faces[i], faces[j], faces[k] });
        }
      }
    }
    return places;
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

  void AddMeeting(Index v, std::vector<Place>& places, std::vector<const Sheet*> sheets) const
  {
    const Vec3 point = MeetSheets(this->TheMesh.Points[v], sheets);
    if (this->ThePlacement.IsWithinReach(v, point))
    {
      places.push_back({ point, std::move(sheets) });
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

  bool IsCommon(Index v) const
  {
    return !this->TheConnectivity.Common.empty() && this->TheConnectivity.Common[v];
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Labelling& TheLabelling;
  const std::vector<Vec3>& Input;
  Placement& ThePlacement;
  std::vector<Index> ColourOf; // each vertex that has one in this sweep; else NoIndex
  std::vector<Index> Ring; // working memory
};
}

void Straighten(const Mesh& mesh, const Connectivity& connectivity, const Labelling& labelling,
  const std::vector<Vec3>& input, const std::vector<Index>& damaged, Placement& placement)
{
  Straightener(mesh, connectivity, labelling, input, placement).Run(damaged);
}
}
