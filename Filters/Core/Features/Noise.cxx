// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Noise.h"

#include "Core/IndexSet.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace arris
{
namespace
{
/// The triangles whose edges tell how noisy the mesh is: about four rings around an edge.
constexpr std::size_t Surroundings = 64;

/// With fewer triangles around there is no telling noise from shape.
constexpr std::size_t FewestForNoise = 24;

/// Noise folds most edges, and as many up as down: the noise is what this part of the edges
/// exceeds, in both directions. Convex and concave parts have none, corrugated ones neither, as
/// only one edge in six lies along each kind of their folds.
constexpr double NoisyPart = 0.3;

/// How far the sides of an edge reach, in edge lengths: there the noise of a mean normal is a
/// tenth of that of one triangle.
constexpr double SideReach = 3.0;

/// A side has some 30 triangles; more than this it has in fans only.
constexpr std::size_t MostOfSide = 200;

/// Looks at one edge after the other.
class Listener
{
public:
  Listener(const Mesh& mesh, const Connectivity& connectivity, const Folds& folds, double factor)
    : Surface(mesh)
    , Adjacency(connectivity)
    , EdgeFolds(folds)
    , NoiseFactor(factor)
  {
  }

  double QuietAngle(const FeatureEdge& edge)
  {
    if (!IsFold(edge.Kind) || this->NoiseFactor == 0.0)
    {
      return edge.DihedralAngle;
    }
    this->GatherAround(edge);
    if (this->Near.size() < FewestForNoise ||
      !this->FoldsBothWays(DifferenceOfAngle(edge.DihedralAngle / this->NoiseFactor)))
    {
      return edge.DihedralAngle;
    }
    const double noise = this->NoiseFactor * this->NoiseLevel();
    std::size_t fewest = 0;
    const double angle = this->AngleOfSides(edge, fewest);
    // What noise is left in the mean of so many triangles; a single one has all of it.
    const double rest = noise / static_cast<double>(fewest);
    return std::max(0.0, std::min(edge.DihedralAngle, angle) - rest);
  }

private:
  /// Collects whole rings around an edge in `Near`, until there are enough triangles.
  void GatherAround(const FeatureEdge& edge)
  {
    this->Start({ edge.Left, edge.Right });
    std::size_t ring = 0;
    while (this->Near.size() < Surroundings && ring < this->Near.size())
    {
      for (const std::size_t end = this->Near.size(); ring < end; ++ring)
      {
        this->AddNeighbors(this->Near[ring], [](Index) { return true; });
      }
    }
  }

  /// Collects one side of an edge in `Near`: the triangles connected with `start` that pass a test.
  template <typename Accept>
  void GatherSide(Index start, Accept&& accept)
  {
    this->Start({ start });
    for (std::size_t i = 0; i < this->Near.size() && this->Near.size() < MostOfSide; ++i)
    {
      this->AddNeighbors(this->Near[i], accept);
    }
  }

  void Start(std::initializer_list<Index> triangles)
  {
    this->Near = triangles;
    this->Seen.Clear();
    for (const Index t : triangles)
    {
      this->Seen.Insert(t);
    }
  }

  template <typename Accept>
  void AddNeighbors(Index t, Accept&& accept)
  {
    for (const Index next : this->Adjacency.AcrossEdge[t])
    {
      if (next != NoIndex && this->Seen.Insert(next) && accept(next))
      {
        this->Near.push_back(next);
      }
    }
  }

  /// Whether a part of the edges around folds by more than a difference, in both directions.
  bool FoldsBothWays(double difference)
  {
    if (!this->FoldsEitherWay(difference))
    {
      return false; // as nearly always: which way need not be known
    }
    this->Differences.clear();
    std::size_t up = 0;
    std::size_t down = 0;
    for (const Index t : this->Near)
    {
      for (int k = 0; k < 3; ++k)
      {
        const float fold = this->DifferenceAt(t, k);
        this->Differences.push_back(fold);
        up += fold > difference ? 1 : 0;
        down += fold < -difference ? 1 : 0;
      }
    }
    return static_cast<double>(std::min(up, down)) > this->NoisyCount();
  }

  float DifferenceAt(Index t, int k) const
  {
    return this->EdgeFolds.Differences.empty()
      ? FoldAt(this->Surface, this->Adjacency, this->EdgeFolds, t, k).Difference
      : this->EdgeFolds.Differences[t][k];
  }

  /// Whether so many may fold by more as must if they do in both directions.
  bool FoldsEitherWay(double difference) const
  {
    if (!this->EdgeFolds.Differences.empty())
    {
      return true; // which way is known as soon
    }
    std::size_t may = 3 * this->Near.size();
    for (const Index t : this->Near)
    {
      for (int k = 0; k < 3; ++k)
      {
        may -= FoldSize(this->Surface, this->Adjacency, this->EdgeFolds, t, k) > difference ? 0 : 1;
      }
      if (static_cast<double>(may) <= 2.0 * this->NoisyCount())
      {
        return false;
      }
    }
    return true;
  }

  double NoisyCount() const { return NoisyPart * 3.0 * static_cast<double>(this->Near.size()); }

  /// The angle that this part of the edges exceeds in both directions, in degrees.
  double NoiseLevel()
  {
    this->Up.clear();
    this->Down.clear();
    for (const float difference : this->Differences)
    {
      this->Up.push_back(std::max(0.0F, difference));
      this->Down.push_back(std::max(0.0F, -difference));
    }
    const auto rank = static_cast<std::ptrdiff_t>((1.0 - NoisyPart) * this->Up.size());
    std::nth_element(this->Up.begin(), this->Up.begin() + rank, this->Up.end());
    std::nth_element(this->Down.begin(), this->Down.begin() + rank, this->Down.end());
    return AngleOfDifference(std::min(this->Up[rank], this->Down[rank]));
  }

  /// The mean length of the edges of the triangles around.
  double EdgeLength() const
  {
    double sum = 0.0;
    for (const Index t : this->Near)
    {
      const Corners corners(this->Surface, t);
      sum += (corners.B - corners.A).norm() + (corners.C - corners.B).norm() +
        (corners.A - corners.C).norm();
    }
    return sum / (3.0 * static_cast<double>(this->Near.size()));
  }

  /// The angle between the mean normals of the two sides, in degrees, and how many triangles the
  /// smaller side has.
  double AngleOfSides(const FeatureEdge& edge, std::size_t& fewest)
  {
    fewest = MostOfSide;
    const double reach = SideReach * this->EdgeLength();
    const Vec3& a = this->Surface.Points[edge.A];
    const Vec3 middle = 0.5 * (a + this->Surface.Points[edge.B]);
    const Vec3 along = this->Surface.Points[edge.B] - a;
    const Vec3 left = Corners(this->Surface, edge.Left).AreaVector();
    const Vec3 right = Corners(this->Surface, edge.Right).AreaVector();
    const Vec3 toTheLeft = (left + right).cross(along);
    const auto side = [&](Index start, double sign)
    {
      this->GatherSide(start,
        [&](Index t)
        {
          const Vec3 from = Corners(this->Surface, t).Centroid() - middle;
          return sign * from.dot(toTheLeft) > 0.0 && from.norm() < reach;
        });
      fewest = std::min(fewest, this->Near.size());
      Vec3 sum = Vec3::Zero();
      for (const Index t : this->Near)
      {
        sum += Corners(this->Surface, t).AreaVector();
      }
      return sum.normalized();
    };
    return AngleOfDifference(0.5 * (side(edge.Left, 1.0) - side(edge.Right, -1.0)).squaredNorm());
  }

  const Mesh& Surface;
  const Connectivity& Adjacency;
  const Folds& EdgeFolds;
  const double NoiseFactor;
  IndexSet Seen;
  std::vector<Index> Near;
  std::vector<float> Differences, Up, Down; // of the edges in `Near`
};
}

std::vector<double> QuietAngles(const Mesh& mesh, const Connectivity& connectivity,
  const Folds& folds, const std::vector<FeatureEdge>& edges, double noiseFactor,
  const Monitor& monitor)
{
  std::vector<double> angles(edges.size());
  const bool finished = ParallelFor(static_cast<Index>(edges.size()), monitor,
    [&](Index begin, Index end)
    {
      Listener listener(mesh, connectivity, folds, noiseFactor);
      for (Index i = begin; i < end; ++i)
      {
        angles[i] = listener.QuietAngle(edges[i]);
      }
    });
  if (!finished)
  {
    return {};
  }
  return angles;
}
}
