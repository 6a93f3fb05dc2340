// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Sharpening.h"

#include "ConnectedWindow.h"
#include "FreeBoundary.h"
#include "Geometry.h"
#include "Predictor.h"
#include "Thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace arris
{
namespace
{
/// The first support of a predictor, in windows, and the step it grows by until it reaches a static
/// triangle: the paper's α (section 4.3).
constexpr double FirstSupport = 0.5;
constexpr double SupportStep = 0.1;

/// Support up to the farthest neighbour takes in the triangles that touch the ball in that
/// neighbour alone. They are at exactly that distance: without a margin rounding would decide over
/// each.
constexpr double SupportMargin = 1.0 + 1e-9;

/// The longest translation, in average edge lengths (section 4.3).
constexpr double LongestTranslation = 4.0;

/// The smallest radius FirstSupport + k SupportStep (in windows) that reaches `distance`.
double GrownSupport(double distance, double windowRadius)
{
  const double steps = std::ceil((distance / windowRadius - FirstSupport) / SupportStep);
  const double radius = (FirstSupport + std::max(0.0, steps) * SupportStep) * windowRadius;
  return std::max(radius, distance); // where rounding left it a bit short
}

/// The mesh while its sharp vertices become static, one group after the other.
class MovingMesh
{
public:
  MovingMesh(Mesh mesh, const Connectivity& connectivity, const std::vector<int>& rounds,
    const Skeleton& skeleton, double windowRadius, double averageEdgeLength)
    : Current(std::move(mesh))
    , TheConnectivity(connectivity)
    , TheSkeleton(skeleton)
    , Static(rounds.size())
    , WindowRadius(windowRadius)
    , Longest(LongestTranslation * averageEdgeLength)
  {
    std::transform(rounds.begin(), rounds.end(), this->Static.begin(),
      [](int round) -> unsigned char { return round == NeverSharp ? 1 : 0; });
    Flags sharp(rounds.size());
    std::transform(this->Static.begin(), this->Static.end(), sharp.begin(),
      [](unsigned char isStatic) -> unsigned char { return isStatic ? 0 : 1; });
    this->Walls = FindWalls(
      this->Current, connectivity, sharp, std::vector<double>(rounds.size(), averageEdgeLength));
  }

  /// Predicts all vertices of the group from the static triangles, then moves them and makes them
  /// static.
  template <typename Predict>
  void MoveTogether(const std::vector<Index>& group, Predict&& predict)
  {
    std::vector<Vec3> positions(group.size());
    ParallelFor(static_cast<Index>(group.size()),
      [&](Index begin, Index end)
      {
        ConnectedWindow window(this->Current, this->TheConnectivity);
        for (Index i = begin; i < end; ++i)
        {
          positions[i] = predict(group[i], window);
        }
      });
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      this->Current.Points[group[i]] = positions[i];
      this->Static[group[i]] = 1;
    }
  }

  /// The predictor of a vertex that thinning removed: support αλ, centre of the 1-ring.
  Vec3 PredictRemoved(Index vertex, ConnectedWindow& window) const
  {
    return this->Predict(vertex, FirstSupport * this->WindowRadius,
      this->Mean(this->TheConnectivity.NeighborsOfVertex[vertex]), window);
  }

  /// The predictor of a skeleton vertex: as far as its farthest neighbour, centre of its
  /// neighbours on the skeleton. The end of a skeleton has one neighbour there, on top of which
  /// that centre would put it: it keeps to the centre of its 1-ring.
  Vec3 PredictSkeleton(Index vertex, ConnectedWindow& window) const
  {
    const IndexSpan neighbors = this->TheConnectivity.NeighborsOfVertex[vertex];
    double farthest2 = 0.0;
    for (Index neighbor : neighbors)
    {
      farthest2 = std::max(
        farthest2, (this->Current.Points[neighbor] - this->Current.Points[vertex]).squaredNorm());
    }
    const bool isEnd = this->TheSkeleton.Roles[vertex] == SkeletonRole::End;
    return this->Predict(vertex, SupportMargin * std::sqrt(farthest2),
      this->Mean(isEnd ? neighbors : this->TheSkeleton.SharpNeighbors[vertex]), window);
  }

  std::vector<Vec3> TakePoints() { return std::move(this->Current.Points); }

private:
  /// The centre of a vertex's neighbours.
  Vec3 Mean(IndexSpan vertices) const
  {
    Vec3 sum = Vec3::Zero();
    for (Index v : vertices)
    {
      sum += this->Current.Points[v];
    }
    return sum / vertices.size();
  }

  bool IsStatic(Index triangle) const
  {
    const Triangle& corners = this->Current.Triangles[triangle];
    return this->Static[corners[0]] && this->Static[corners[1]] && this->Static[corners[2]];
  }

  /// Adds the planes of the static triangles of a window; how many there were.
  int AddStaticPlanes(const std::vector<Index>& window, Predictor& predictor) const
  {
    int count = 0;
    for (Index t : window)
    {
      if (!this->IsStatic(t))
      {
        continue;
      }
      const Corners corners(this->Current, t);
      const Vec3 areaVector = corners.AreaVector();
      const double twiceArea = areaVector.norm();
      if (twiceArea > std::numeric_limits<double>::min())
      {
        predictor.AddPlane(corners.Centroid(), areaVector / twiceArea, 0.5 * twiceArea);
        ++count;
      }
    }
    return count;
  }

  /// Grows the support until it holds a static triangle. Without any, in a part that is sharp all
  /// over, nothing is known and the vertex stays.
  Vec3 Predict(Index vertex, double radius, const Vec3& center, ConnectedWindow& window) const
  {
    for (;;)
    {
      Predictor predictor(center);
      if (this->AddStaticPlanes(window.Gather(vertex, radius), predictor) > 0)
      {
        return this->InWall(vertex, predictor);
      }
      if (!std::isfinite(window.NextDistance()))
      {
        return this->Current.Points[vertex];
      }
      radius =
        GrownSupport(std::max(window.NextDistance(), radius + SupportStep * this->WindowRadius),
          this->WindowRadius);
    }
  }

  /// What the predictor says, but on the free boundary if the vertex was there.
  Vec3 InWall(Index vertex, Predictor& predictor) const
  {
    if (this->Walls.empty() ||
      (this->Walls[vertex].Normal.isZero(0.0) && !this->Walls[vertex].Fixed))
    {
      return predictor.Position(this->Longest);
    }
    const Vec3& before = this->Current.Points[vertex]; // each vertex moves once
    if (this->Walls[vertex].Fixed)
    {
      return before;
    }
    // As heavy as all other planes together, so that it is no sliver of them; then exactly.
    const Vec3& normal = this->Walls[vertex].Normal;
    predictor.AddPlane(before, normal, predictor.Weight());
    const Vec3 position = predictor.Position(this->Longest);
    return position - normal.dot(position - before) * normal;
  }

  Mesh Current;
  const Connectivity& TheConnectivity;
  const Skeleton& TheSkeleton;
  Flags Static;
  double WindowRadius;
  double Longest;
  std::vector<Wall> Walls; // of sharp vertices on free boundaries; empty if there are none
};

/// The vertices of each thinning round, 1 first; the skeleton is not among them.
std::vector<std::vector<Index>> GroupByRound(
  const std::vector<int>& rounds, const Skeleton& skeleton)
{
  std::vector<std::vector<Index>> groups;
  for (std::size_t v = 0; v < rounds.size(); ++v)
  {
    if (rounds[v] != NeverSharp && skeleton.Roles[v] == SkeletonRole::None)
    {
      const std::size_t group = static_cast<std::size_t>(rounds[v]) - 1;
      if (group >= groups.size())
      {
        groups.resize(group + 1);
      }
      groups[group].push_back(static_cast<Index>(v));
    }
  }
  return groups;
}

std::vector<Index> VerticesOn(const Skeleton& skeleton, bool joints)
{
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < skeleton.Roles.size(); ++v)
  {
    const SkeletonRole role = skeleton.Roles[v];
    if (role != SkeletonRole::None && (role == SkeletonRole::Joint) == joints)
    {
      vertices.push_back(static_cast<Index>(v));
    }
  }
  return vertices;
}
}

std::vector<Vec3> SharpenedPoints(Mesh mesh, const Connectivity& connectivity,
  const std::vector<int>& thinningRounds, const Skeleton& skeleton, double windowRadius,
  double averageEdgeLength, const Monitor& monitor)
{
  MovingMesh moving(
    std::move(mesh), connectivity, thinningRounds, skeleton, windowRadius, averageEdgeLength);
  const std::vector<std::vector<Index>> groups = GroupByRound(thinningRounds, skeleton);
  const double stages = static_cast<double>(groups.size()) + 2.0; // and branches and joints
  double done = 0.0;
  for (const std::vector<Index>& group : groups)
  {
    if (!monitor.Report(done++ / stages))
    {
      return {};
    }
    moving.MoveTogether(group,
      [&](Index vertex, ConnectedWindow& window) { return moving.PredictRemoved(vertex, window); });
  }
  for (bool joints : { false, true })
  {
    if (!monitor.Report(done++ / stages))
    {
      return {};
    }
    moving.MoveTogether(VerticesOn(skeleton, joints),
      [&](Index vertex, ConnectedWindow& window)
      { return moving.PredictSkeleton(vertex, window); });
  }
  return moving.TakePoints();
}
}
