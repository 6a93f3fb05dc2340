// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FreeBoundary.h"

#include "Geometry.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>

namespace arris
{
namespace
{
/// As far along the boundary both ways it is looked at, in scales: past what sampling spoils beside
/// an edge, and as far again.
constexpr double Reach = 5.0;

/// A boundary this near to a plane (root mean square, in scales) was cut by it: what single
/// precision and clipping leave is far less, and what bends in space is mostly more.
constexpr double PlaneResidual = 0.01;

/// A boundary this near to a line determines no plane, in scales.
constexpr double LineResidual = 0.05;

/// The surface crosses the plane of its boundary at this angle at least, in degrees.
constexpr double LeastCrossing = 30.0;

/// A free boundary that turns by more than this in a vertex has a corner there, in degrees.
constexpr double SharpTurn = 45.0;

/// The free boundary as curves: the neighbours of each vertex on it.
class BoundaryCurves
{
public:
  BoundaryCurves(const Mesh& mesh, const Connectivity& connectivity)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
  {
    for (Index t = 0; t < mesh.TriangleCount(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index a = mesh.Triangles[t][k], b = mesh.Triangles[t][Next(k)];
        if (connectivity.AcrossEdge[t][k] == NoIndex && this->IsAlone(t, a, b))
        {
          this->Neighbors[a].push_back(b);
          this->Neighbors[b].push_back(a);
        }
      }
    }
  }

  bool IsEmpty() const { return this->Neighbors.empty(); }
  bool Has(Index vertex) const { return this->Neighbors.count(vertex) > 0; }

  Wall WallOf(Index vertex, double scale) const
  {
    const std::vector<Index>& next = this->Neighbors.at(vertex);
    Wall wall;
    const Vec3 normal = DirectionOf(AreaVectorAround(this->TheMesh, this->TheConnectivity, vertex));
    if (next.size() != 2 || !(normal.norm() > 0.0))
    {
      wall.Fixed = true; // curves meet here
      return wall;
    }
    std::vector<Vec3> points(1, this->TheMesh.Points[vertex]);
    this->Walk(vertex, next[0], Reach * scale, points);
    this->Walk(vertex, next[1], Reach * scale, points);
    if (CutByPlane(points, normal, scale, wall.Normal))
    {
      return wall;
    }
    const Vec3 to = (this->TheMesh.Points[next[1]] - points[0]).normalized();
    const Vec3 from = (points[0] - this->TheMesh.Points[next[0]]).normalized();
    wall.Fixed = from.dot(to) < std::cos(SharpTurn * Pi / 180.0);
    wall.Normal = (from + to).cross(normal).normalized();
    return wall;
  }

private:
  bool IsAlone(Index triangle, Index a, Index b) const
  {
    for (Index t : this->TheConnectivity.TrianglesOfVertex[a])
    {
      const Triangle& corners = this->TheMesh.Triangles[t];
      if (t != triangle && std::find(corners.begin(), corners.end(), b) != corners.end())
      {
        return false;
      }
    }
    return true;
  }

  /// Adds the points along the boundary from `start` over `next`, up to that far away.
  void Walk(Index start, Index next, double reach, std::vector<Vec3>& points) const
  {
    Index before = start;
    double length = 0.0;
    while (next != start)
    {
      length += (this->TheMesh.Points[next] - this->TheMesh.Points[before]).norm();
      const std::vector<Index>& beyond = this->Neighbors.at(next);
      if (length > reach || beyond.size() != 2)
      {
        return;
      }
      points.push_back(this->TheMesh.Points[next]);
      const Index after = beyond[0] == before ? beyond[1] : beyond[0];
      before = next;
      next = after;
    }
  }

  /// Whether the points lie in a plane, and on no line in it, that the surface crosses.
  static bool CutByPlane(
    const std::vector<Vec3>& points, const Vec3& surfaceNormal, double scale, Vec3& normal)
  {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& point : points)
    {
      mean += point / static_cast<double>(points.size());
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& point : points)
    {
      spread += (point - mean) * (point - mean).transpose() / static_cast<double>(points.size());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const auto residual = [&](int axis)
    { return std::sqrt(std::max(0.0, solver.eigenvalues()[axis])) / scale; };
    if (residual(0) > PlaneResidual || residual(1) < LineResidual)
    {
      return false;
    }
    normal = solver.eigenvectors().col(0);
    return std::abs(normal.dot(surfaceNormal)) < std::cos(LeastCrossing * Pi / 180.0);
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  std::map<Index, std::vector<Index>> Neighbors;
};
}

std::vector<Wall> FindWalls(const Mesh& mesh, const Connectivity& connectivity, const Flags& flags,
  const std::vector<double>& scales)
{
  const BoundaryCurves curves(mesh, connectivity);
  if (curves.IsEmpty())
  {
    return {};
  }
  std::vector<Wall> walls(mesh.Points.size());
  for (Index v = 0; v < mesh.VertexCount(); ++v)
  {
    if (flags[v] && curves.Has(v))
    {
      walls[v] = curves.WallOf(v, scales[v]);
    }
  }
  return walls;
}
}
