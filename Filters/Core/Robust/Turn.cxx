// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Turn.h"

#include "Core/Geometry.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace arris
{
namespace
{
// Lengths in local scales. The sides are looked at in a ring: nearer than its inner radius a
// sampled edge is damaged, farther than the outer one the next feature may begin.
constexpr double RingInner = 1.0;
constexpr double RingOuter = 3.0;
constexpr double WideRingShift = 0.5;
constexpr double HalfWidthAlong = 1.5; // how far along the edge a side reaches

/// The least area of a side that can be believed, in squares of the local scale.
constexpr double LeastSideArea = 0.3;

/// The same for what is left of a side that ends nearer than the ring.
constexpr double LeastCloseArea = 0.1;

/// Pulls the slope of a side toward none, in squares of the local scale, where its faces stand in
/// one row and give no slope.
constexpr double SlopeRidge = 0.02;

/// The mean square of sines by which normals turn in a direction: under 1.5 degrees (root mean
/// square) no jump in that direction reaches that of an edge.
constexpr double LeastSpread = 7e-4;

double Degrees(double radians)
{
  return radians * 180.0 / Pi;
}

double AngleBetween(const Vec3& a, const Vec3& b)
{
  return Degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}
}

TurnMeter::TurnMeter(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const std::vector<double>& scales)
  : TheMesh(mesh)
  , TheConnectivity(connectivity)
  , TheFaces(faces)
  , Scales(scales)
  , Window(mesh, connectivity)
{
}

Turn TurnMeter::Measure(Index vertex)
{
  Turn best;
  this->Scale = this->Scales[vertex];
  this->Position = this->TheMesh.Points[vertex];
  const std::vector<Index>& window = this->GatherWindow(vertex);
  best.Deviation = AngleOfDifference(this->Spread.Largest(window, this->TheFaces.Normals));
  if (best.Deviation < FlatDeviation)
  {
    return best;
  }

  this->GatherNear(vertex, RingOuter + WideRingShift);
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (const SeenFace& seen : this->Near)
  {
    sum += seen.AreaVector;
    area += seen.Area;
  }
  if (!(sum.norm() > 0.0))
  {
    return best;
  }
  const Vec3 meanNormal = sum.normalized();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const SeenFace& seen : this->Near)
  {
    if (seen.Area > 0.0)
    {
      const Vec3 difference = seen.AreaVector / seen.Area - meanNormal;
      spread += seen.Area * difference * difference.transpose();
    }
  }
  // Across the edge the normals vary most. At a hole's rim they may vary more along it: the second
  // direction is tried as well.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(spread);
  for (int axis : { 2, 1 })
  {
    if (solver.eigenvalues()[axis] < LeastSpread * area)
    {
      break;
    }
    Vec3 across = solver.eigenvectors().col(axis);
    across -= across.dot(meanNormal) * meanNormal;
    if (across.norm() < 0.3)
    {
      continue;
    }
    across.normalize();
    Turn turn = best;
    this->MeasureAcross(meanNormal, across, window, turn);
    if (axis == 2 || turn.Jump > best.Jump)
    {
      best = turn;
    }
  }
  return best;
}

void TurnMeter::MeasureAcross(
  const Vec3& meanNormal, const Vec3& across, const std::vector<Index>& window, Turn& turn) const
{
  const Vec3 along = meanNormal.cross(across);
  SideSums sums[2], wide[2], close[2]; // left and right
  for (const SeenFace& seen : this->Near)
  {
    const double s = seen.Offset.dot(across);
    const double reach = std::abs(s);
    if (std::abs(seen.Offset.dot(along)) > HalfWidthAlong)
    {
      continue;
    }
    const double squared = seen.Offset.squaredNorm();
    const int which = s > 0.0 ? 1 : 0;
    if (reach < RingInner)
    {
      if (this->BelieveClose)
      {
        close[which].Add(s, seen.Area, seen.AreaVector);
      }
      continue;
    }
    if (squared <= RingOuter * RingOuter)
    {
      sums[which].Add(s, seen.Area, seen.AreaVector);
    }
    if (reach >= RingInner + WideRingShift)
    {
      wide[which].Add(s, seen.Area, seen.AreaVector); // all are near enough
    }
  }
  const double leastArea = LeastSideArea * this->Scale * this->Scale;
  Side left = sums[0].Fit(leastArea);
  Side right = sums[1].Fit(leastArea);
  if (this->BelieveClose) // of a side that the other edge cuts off, the beginning is left
  {
    const double leastClose = LeastCloseArea * this->Scale * this->Scale;
    left = left.Known ? left : close[0].FitLevel(leastClose);
    right = right.Known ? right : close[1].FitLevel(leastClose);
  }
  turn.Jump = this->JumpOf(left, right, across);
  turn.WideJump = this->JumpOf(wide[0].Fit(leastArea), wide[1].Fit(leastArea), across);

  double least = 1e300, most = -1e300, first = 1e300, last = -1e300;
  for (Index face : window)
  {
    const Vec3& normal = this->TheFaces.Normals[face];
    if (normal.isZero(0.0))
    {
      continue;
    }
    const double angle = Degrees(std::atan2(normal.dot(across), normal.dot(meanNormal)));
    least = std::min(least, angle);
    most = std::max(most, angle);
    const Vec3 centroid = Corners(this->TheMesh, face).Centroid();
    const double s = (centroid - this->Position).dot(across) / this->Scale;
    first = std::min(first, s);
    last = std::max(last, s);
  }
  turn.Across = most > least ? most - least : 0.0;
  const double steepest = std::max(std::abs(left.Known ? left.Slope.dot(across) : 0.0),
    std::abs(right.Known ? right.Slope.dot(across) : 0.0));
  turn.Concentrated = turn.Across - Degrees((last - first) * steepest);
}

const std::vector<Index>& TurnMeter::GatherWindow(Index vertex)
{
  const std::vector<Index>& window = this->Window.Gather(vertex, TurnWindow * this->Scale);
  if (this->Barrier == nullptr)
  {
    return window;
  }
  this->ClearWindow.clear();
  std::copy_if(window.begin(), window.end(), std::back_inserter(this->ClearWindow),
    [this](Index face) { return !this->IsBarrier(face); });
  return this->ClearWindow;
}

bool TurnMeter::IsBarrier(Index face) const
{
  if (this->Barrier == nullptr)
  {
    return false;
  }
  const Triangle& corners = this->TheMesh.Triangles[face];
  const Flags& region = *this->Barrier;
  return region[corners[0]] + region[corners[1]] + region[corners[2]] > 1;
}

void TurnMeter::GatherNear(Index vertex, double radius)
{
  this->Near.clear();
  this->Seen.Clear();
  const auto look = [&](Index face)
  {
    if (face == NoIndex || !this->Seen.Insert(face) || this->IsBarrier(face))
    {
      return;
    }
    const Corners corners(this->TheMesh, face);
    const Vec3 offset = (corners.Centroid() - this->Position) / this->Scale;
    if (offset.squaredNorm() <= radius * radius)
    {
      const Vec3 areaVector = 0.5 * corners.AreaVector();
      this->Near.push_back({ offset, areaVector, areaVector.norm(), face });
    }
  };
  for (Index face : this->TheConnectivity.TrianglesOfVertex[vertex])
  {
    look(face);
  }
  std::size_t next = 0;
  while (next < this->Near.size()) // which look() makes longer
  {
    const Index seen = this->Near[next++].Face;
    for (Index face : this->TheConnectivity.AcrossEdge[seen])
    {
      look(face);
    }
  }
}

void TurnMeter::SideSums::Add(double s, double area, const Vec3& areaVector)
{
  this->Area += area;
  this->S += area * s;
  this->SS += area * s * s;
  this->N += areaVector;
  this->SN += s * areaVector;
}

TurnMeter::Side TurnMeter::SideSums::Fit(double leastArea) const
{
  Side side;
  if (this->Area < leastArea)
  {
    return side;
  }
  const double meanS = this->S / this->Area;
  side.Mean = this->N / this->Area;
  side.Slope = (this->SN / this->Area - meanS * side.Mean) /
    (this->SS / this->Area - meanS * meanS + SlopeRidge);
  side.Intercept = side.Mean - meanS * side.Slope;
  side.Known = true;
  return side;
}

TurnMeter::Side TurnMeter::SideSums::FitLevel(double leastArea) const
{
  Side side;
  side.Known = this->Area >= leastArea;
  if (side.Known)
  {
    side.Mean = side.Intercept = this->N / this->Area;
    side.Slope = Vec3::Zero();
  }
  return side;
}

double TurnMeter::JumpOf(const Side& left, const Side& right, const Vec3& across) const
{
  if (!left.Known || !right.Known)
  {
    return 0.0;
  }
  const double angle = AngleBetween(left.Intercept, right.Intercept);
  const bool against =
    (right.Intercept - left.Intercept).dot(across) * (right.Mean - left.Mean).dot(across) < 0.0;
  return against ? -angle : angle;
}
}
