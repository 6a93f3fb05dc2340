// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceFit.h"

#include "Core/Geometry.h"
#include "Refine.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
/// More triangles than this make no parameter better.
constexpr std::size_t MostOfSample = 500;

/// As many triangles must there be as a torus has parameters, before any curved shape is thought
/// of.
constexpr std::size_t FewestForCurved = 7;

/// A shape with more parameters is always nearer; it is only taken if it is so many times nearer.
constexpr double Parsimony = 2.0;

/// What is nearer than this, in parts of the face's size, is exact: files hold six digits.
constexpr double Exact = 1e-5;

constexpr double NormalTolerance = 10.0; // degrees

/// Every n-th triangle of a face, such that there are enough and not too many.
FaceSample Sample(const Mesh& mesh, IndexSpan triangles)
{
  const Index stride = static_cast<Index>(triangles.size() / MostOfSample) + 1;
  FaceSample face;
  double area = 0.0;
  for (Index i = 0; i < triangles.size(); i += stride)
  {
    const Corners corners(mesh, triangles[i]);
    const Vec3 areaVector = corners.AreaVector();
    const double twice = areaVector.norm();
    if (twice > 0.0)
    {
      face.Items.push_back(
        { { corners.A, corners.B, corners.C }, corners.Centroid(), areaVector / twice, twice });
      area += twice;
    }
  }
  for (FaceSample::Item& item : face.Items)
  {
    item.Weight /= area;
  }
  return face;
}

/// Lengths that tolerances refer to.
struct Scale
{
  double Size = 0.0; ///< RMS distance of the corners from their mean, times two
  double EdgeLength = 0.0; ///< mean

  explicit Scale(const FaceSample& face)
  {
    Vec3 mean = Vec3::Zero();
    for (const FaceSample::Item& item : face.Items)
    {
      mean += item.Weight * item.Centroid;
    }
    for (const FaceSample::Item& item : face.Items)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Size += item.Weight / 3.0 * (item.Corners[k] - mean).squaredNorm();
        this->EdgeLength += (item.Corners[Next(k)] - item.Corners[k]).norm();
      }
    }
    this->Size = 2.0 * std::sqrt(this->Size);
    this->EdgeLength /= 3.0 * static_cast<double>(face.Items.size());
  }
};

/// How far a shape is from the triangles of a face.
struct Misfit
{
  double Distance = 0.0; ///< RMS of the corners
  double Angle = 0.0; ///< RMS between the normals, degrees

  Misfit(const FaceSample& face, const Primitive& shape)
  {
    for (const FaceSample::Item& item : face.Items)
    {
      for (const Vec3& corner : item.Corners)
      {
        const double distance = shape.Distance(corner);
        this->Distance += item.Weight / 3.0 * distance * distance;
      }
      const double cosine = std::min(1.0, std::abs(shape.Normal(item.Centroid).dot(item.Normal)));
      const double angle = AngleOfDifference(1.0 - cosine);
      this->Angle += item.Weight * angle * angle;
    }
    this->Distance = std::sqrt(this->Distance);
    this->Angle = std::sqrt(this->Angle);
  }

  /// Both in one: an edge that is turned by the angle leads as far away.
  double Total(const Scale& scale) const
  {
    return std::hypot(this->Distance, scale.EdgeLength * this->Angle * Pi / 180.0);
  }
};

/// RMS distance of all corners of a face, by area.
double ResidualOf(const Mesh& mesh, IndexSpan triangles, const Primitive& shape)
{
  double sum = 0.0;
  double area = 0.0;
  for (const Index t : triangles)
  {
    const Corners corners(mesh, t);
    const double weight = corners.AreaVector().norm();
    area += 3.0 * weight;
    for (const Vec3& corner : { corners.A, corners.B, corners.C })
    {
      const double distance = shape.Distance(corner);
      sum += weight * distance * distance;
    }
  }
  return area > 0.0 ? std::sqrt(sum / area) : 0.0;
}

FaceFit FitFace(const Mesh& mesh, IndexSpan triangles, double tolerance)
{
  using Guess = bool (*)(const FaceSample&, Primitive&);
  constexpr Guess Guesses[] = { GuessPlane, GuessSphere, GuessCylinder, GuessCone, GuessTorus };
  const FaceSample face = Sample(mesh, triangles);
  FaceFit best;
  if (face.Items.empty())
  {
    return best;
  }
  const Scale scale(face);
  double least = 0.0; // misfit, of the best
  bool fits = false;
  Primitive nearest;
  double nearestDistance = -1.0;
  for (const Guess guess : Guesses)
  {
    Primitive shape;
    if (!guess(face, shape))
    {
      continue;
    }
    Refine(face, scale.Size, shape);
    const Misfit misfit(face, shape);
    const double total = misfit.Total(scale);
    if (!std::isfinite(total))
    {
      continue;
    }
    if (nearestDistance < 0.0 || misfit.Distance < nearestDistance)
    {
      nearest = shape;
      nearestDistance = misfit.Distance;
    }
    if (misfit.Distance <= tolerance * scale.EdgeLength && misfit.Angle <= NormalTolerance &&
      (!fits || Parsimony * std::max(total, Exact * scale.Size) < least))
    {
      best.Shape = shape;
      least = total;
      fits = true;
    }
    const bool exact =
      fits && least <= Exact * scale.Size; // distances and normals: no use to go on
    if (face.Items.size() < FewestForCurved || exact)
    {
      break;
    }
  }
  best.Residual = ResidualOf(mesh, triangles, fits ? best.Shape : nearest);
  return best;
}

/// The triangles of each surface, ascending.
Rows TrianglesOfSurfaces(const std::vector<Index>& surfaceIds, Index surfaceCount)
{
  Rows rows;
  rows.Offsets.assign(surfaceCount + 1, 0);
  for (const Index id : surfaceIds)
  {
    ++rows.Offsets[id + 1];
  }
  for (Index s = 0; s < surfaceCount; ++s)
  {
    rows.Offsets[s + 1] += rows.Offsets[s];
  }
  std::vector<Index> next(rows.Offsets.begin(), rows.Offsets.end() - 1);
  rows.Values.resize(surfaceIds.size());
  for (std::size_t t = 0; t < surfaceIds.size(); ++t)
  {
    rows.Values[next[surfaceIds[t]]++] = static_cast<Index>(t);
  }
  return rows;
}
}

std::vector<FaceFit> FitFaces(const Mesh& mesh, const std::vector<Index>& surfaceIds,
  Index surfaceCount, double tolerance, const Monitor& monitor)
{
  const Rows triangles = TrianglesOfSurfaces(surfaceIds, surfaceCount);
  std::vector<FaceFit> fits(surfaceCount);
  const bool finished = ParallelFor(surfaceCount, monitor,
    [&](Index begin, Index end)
    {
      for (Index s = begin; s < end; ++s)
      {
        fits[s] = FitFace(mesh, triangles[s], tolerance);
      }
    });
  return finished ? fits : std::vector<FaceFit>();
}
}
