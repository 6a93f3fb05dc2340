// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Comparison.h"

#include "Failure.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocalObject.h>
#include <vtkSMPTools.h>
#include <vtkStaticCellLocator.h>
#include <vtkTriangle.h>
#include <vtkTriangleFilter.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace arris
{
namespace
{
using Point = Eigen::Vector3d;
using Corners = std::array<Point, 3>;

double Area(const Corners& c)
{
  return 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm();
}

vtkSmartPointer<vtkPolyData> TrianglesOf(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> faces;
  faces->SetPoints(surface->GetPoints());
  faces->SetPolys(surface->GetPolys());
  faces->SetStrips(surface->GetStrips());
  vtkNew<vtkTriangleFilter> cutter;
  cutter->SetInputData(faces);
  cutter->Update();
  return cutter->GetOutput();
}

/// A surface cut into triangles.
struct Triangles
{
  vtkSmartPointer<vtkPolyData> Surface;
  std::vector<Corners> Faces;
  std::vector<Point> Vertices; ///< those that faces use
  double TotalArea = 0.0;

  Triangles(vtkPolyData* surface, const char* name)
    : Surface(TrianglesOf(surface))
  {
    std::vector<unsigned char> used(this->Surface->GetNumberOfPoints(), 0);
    vtkNew<vtkIdList> ids;
    for (vtkIdType t = 0; t < this->Surface->GetNumberOfPolys(); ++t)
    {
      this->Surface->GetPolys()->GetCellAtId(t, ids);
      Corners corners;
      for (int k = 0; k < 3; ++k)
      {
        this->Surface->GetPoint(ids->GetId(k), corners[k].data());
        used[ids->GetId(k)] = 1;
      }
      this->Faces.push_back(corners);
      this->TotalArea += Area(corners);
    }
    for (vtkIdType v = 0; v < this->Surface->GetNumberOfPoints(); ++v)
    {
      if (used[v])
      {
        this->Vertices.emplace_back();
        this->Surface->GetPoint(v, this->Vertices.back().data());
      }
    }
    if (!std::isfinite(this->TotalArea))
    {
      throw Failure(name, "has a coordinate that is not a finite number", "repair it first");
    }
    if (this->TotalArea == 0.0)
    {
      throw Failure(name, "has no area to compare", "give a mesh of triangles or polygons");
    }
  }

  double Diagonal() const
  {
    vtkBoundingBox box;
    for (const Point& vertex : this->Vertices)
    {
      box.AddPoint(vertex[0], vertex[1], vertex[2]);
    }
    return box.GetDiagonalLength();
  }
};

/// Finds the nearest point of a surface; from any number of threads.
class NearestPoint
{
public:
  explicit NearestPoint(const Triangles& triangles)
  {
    triangles.Surface->BuildCells(); // not safe to leave to the threads
    this->Locator->SetDataSet(triangles.Surface);
    this->Locator->BuildLocator();
  }

  /// The distance from points that are asked for one after the other and lie near each other: it
  /// grows by no more than the step from one to the next, and a short search is a fast one.
  class Walk
  {
  public:
    explicit Walk(NearestPoint& target)
      : Target(target)
    {
    }

    double DistanceFrom(const Point& p)
    {
      if (std::isfinite(this->Distance))
      {
        // A little more than that, for rounding; so that it is never missed.
        constexpr double Rounding = 1e-6;
        const double step = (p - this->Last).norm();
        const double size = p.cwiseAbs().maxCoeff();
        this->Distance =
          this->Target.Search(p, (1.0 + Rounding) * (this->Distance + step) + Rounding * size);
      }
      if (!std::isfinite(this->Distance))
      {
        this->Distance = this->Target.Search(p);
      }
      this->Last = p;
      return this->Distance;
    }

  private:
    NearestPoint& Target;
    Point Last = Point::Zero();
    double Distance = Infinity;
  };

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  double Search(const Point& p)
  {
    Point nearest;
    vtkIdType cell = -1;
    int part = 0;
    double squared = Infinity;
    this->Locator->FindClosestPoint(
      p.data(), nearest.data(), this->Cells.Local(), cell, part, squared);
    return std::sqrt(squared);
  }

  /// Infinity if there is nothing within the radius.
  double Search(Point p, double radius)
  {
    Point nearest;
    vtkIdType cell = -1;
    int part = 0;
    int inside = 0;
    double squared = Infinity;
    const bool found = this->Locator->FindClosestPointWithinRadius(p.data(), radius, nearest.data(),
                         this->Cells.Local(), cell, part, squared, inside) == 1;
    return found ? std::sqrt(squared) : Infinity;
  }

  vtkNew<vtkStaticCellLocator> Locator;
  vtkSMPThreadLocalObject<vtkGenericCell> Cells;
};

/// What the samples of one triangle add up to.
struct Sum
{
  double Max = 0.0;
  double Mean = 0.0;
  double MeanSquare = 0.0;
  vtkIdType Samples = 0;
};

/// Cuts each side of a triangle into `pieces`, and so the triangle into pieces² of the same area:
/// their middles stand for the face; the cuts, for its edges.
Sum SampleFace(const Corners& c, int pieces, NearestPoint::Walk& target)
{
  Sum sum;
  const Point u = (c[1] - c[0]) / pieces;
  const Point v = (c[2] - c[0]) / pieces;
  const auto sampleMiddle = [&](double i, double j)
  {
    const double distance = target.DistanceFrom(c[0] + i * u + j * v);
    sum.Max = std::max(sum.Max, distance);
    sum.Mean += distance;
    sum.MeanSquare += distance * distance;
    ++sum.Samples;
  };
  constexpr double Third = 1.0 / 3.0;
  for (int i = 0; i < pieces; ++i)
  {
    for (int j = 0; i + j < pieces; ++j)
    {
      sampleMiddle(i + Third, j + Third);
      if (i + j + 1 < pieces)
      {
        sampleMiddle(i + 2.0 * Third, j + 2.0 * Third);
      }
    }
  }
  sum.Mean /= static_cast<double>(sum.Samples);
  sum.MeanSquare /= static_cast<double>(sum.Samples);
  for (int side = 0; side < 3; ++side)
  {
    const Point step = (c[(side + 1) % 3] - c[side]) / pieces;
    for (int i = 1; i < pieces; ++i)
    {
      sum.Max = std::max(sum.Max, target.DistanceFrom(c[side] + i * step));
      ++sum.Samples;
    }
  }
  return sum;
}

/// Runs body(begin, end) for stretches that cover [0, count) on all threads, with word to
/// `progress` in between.
template <typename Body>
void ForEach(vtkIdType count, const std::function<void(double)>& progress, Body&& body)
{
  constexpr vtkIdType MostSlabs = 50;
  const vtkIdType slab = count / MostSlabs + 1;
  for (vtkIdType first = 0; first < count; first += slab)
  {
    if (progress)
    {
      progress(static_cast<double>(first) / static_cast<double>(count));
    }
    vtkSMPTools::For(first, std::min(first + slab, count), body);
  }
}

vtkIdType SamplesFor(const Triangles& triangles, vtkIdType samples)
{
  constexpr vtkIdType Fewest = 200000;
  constexpr vtkIdType PerTriangle = 10;
  return samples > 0
    ? samples
    : std::max(Fewest, PerTriangle * static_cast<vtkIdType>(triangles.Faces.size()));
}

SurfaceDistance DistanceBetween(const Triangles& triangles, const Triangles& other,
  vtkIdType samples, const std::function<void(double)>& progress)
{
  NearestPoint target(other);
  const double density = static_cast<double>(SamplesFor(triangles, samples)) / triangles.TotalArea;
  std::vector<Sum> sums(triangles.Faces.size());
  ForEach(static_cast<vtkIdType>(sums.size()), progress,
    [&](vtkIdType begin, vtkIdType end)
    {
      NearestPoint::Walk walk(target);
      for (vtkIdType t = begin; t < end; ++t)
      {
        const double wanted = density * Area(triangles.Faces[t]);
        const int pieces = std::max(1, static_cast<int>(std::lround(std::sqrt(wanted))));
        sums[t] = SampleFace(triangles.Faces[t], pieces, walk);
      }
    });
  std::vector<double> atVertices(triangles.Vertices.size());
  ForEach(static_cast<vtkIdType>(atVertices.size()), {},
    [&](vtkIdType begin, vtkIdType end)
    {
      NearestPoint::Walk walk(target);
      for (vtkIdType v = begin; v < end; ++v)
      {
        atVertices[v] = walk.DistanceFrom(triangles.Vertices[v]);
      }
    });

  // Added up in the order of storage, so that threads cannot change the last digits.
  SurfaceDistance result;
  double squares = 0.0;
  for (std::size_t t = 0; t < sums.size(); ++t)
  {
    const double share = Area(triangles.Faces[t]) / triangles.TotalArea;
    result.Max = std::max(result.Max, sums[t].Max);
    result.Mean += share * sums[t].Mean;
    squares += share * sums[t].MeanSquare;
    result.Samples += sums[t].Samples;
  }
  for (const double distance : atVertices)
  {
    result.Max = std::max(result.Max, distance);
  }
  result.Samples += static_cast<vtkIdType>(atVertices.size());
  result.Rms = std::sqrt(squares);
  return result;
}
}

Comparison Compare(vtkPolyData* reference, vtkPolyData* mesh, vtkIdType samples,
  const std::function<void(double)>& progress)
{
  const Triangles referenceTriangles(reference, "the reference");
  const Triangles meshTriangles(mesh, "the mesh");
  const auto half = [&](double low)
  {
    return [&progress, low](double fraction)
    {
      if (progress)
      {
        progress(low + 0.5 * fraction);
      }
    };
  };
  Comparison result;
  result.ReferenceToMesh = DistanceBetween(referenceTriangles, meshTriangles, samples, half(0.0));
  result.MeshToReference = DistanceBetween(meshTriangles, referenceTriangles, samples, half(0.5));
  result.Diagonal = referenceTriangles.Diagonal();
  return result;
}
}
