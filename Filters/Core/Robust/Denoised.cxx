// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Denoised.h"

#include "Core/Geometry.h"
#include "HeightField.h"
#include "NearVertices.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
constexpr int Rounds = 5;
constexpr double DenoiseRadius = 5.0; // in local scales: spans a terrace of a segmentation

/// How unlike two normals may be before they count as different faces, in degrees; noise itself
/// makes them differ.
constexpr double LikeAngle = 10.0;
constexpr double LeastLike = 20.0;
constexpr double MostLike = 35.0;

/// Evens out the spacing that noise has spoilt, in local scales a round; without it heavy noise
/// leaves triangles that cut each other.
constexpr double LongestSlide = 0.15;

/// Pulls second order toward none.
constexpr double DenoiseRidge = 0.05;

std::vector<Vec3> VertexNormals(
  const Mesh& mesh, const Connectivity& connectivity, const std::vector<Vec3>& points)
{
  std::vector<Vec3> normals(points.size());
  ParallelFor(mesh.VertexCount(),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        normals[v] = DirectionOf(AreaVectorAround(mesh.Triangles, points, connectivity, v));
      }
    });
  return normals;
}

class Denoiser
{
public:
  Denoiser(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales,
    double likeAngle)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , Scales(scales)
    , LikeDistance(likeAngle * Pi / 180.0)
  {
  }

  /// Where the vertex goes, by the input's positions and the copy's normals.
  Vec3 Moved(Index vertex, const std::vector<Vec3>& points, const std::vector<Vec3>& normals)
  {
    const Vec3& x = points[vertex];
    const Vec3& normal = normals[vertex];
    if (normal.isZero(0.0))
    {
      return x;
    }
    const double scale = this->Scales[vertex];
    const std::vector<Index>& near = this->Near.Gather(
      this->TheMesh.Points, this->TheConnectivity, vertex, x, DenoiseRadius * scale);
    const TangentFrame frame(x, normal, scale);
    HeightField field;
    for (Index v : near)
    {
      const Vec3 p = frame.Local(this->TheMesh.Points[v]);
      const double d = p.norm() / DenoiseRadius;
      const double unlike = (normals[v] - normal).norm() / this->LikeDistance;
      const double weight = std::exp(-2.0 * d * d - unlike * unlike);
      field.Add(p, weight);
    }
    const double height = field.Solve(DenoiseRidge)[0];
    Vec3 slide = Vec3::Zero();
    for (Index n : this->TheConnectivity.NeighborsOfVertex[vertex])
    {
      slide += points[n] - x;
    }
    slide /= static_cast<double>(this->TheConnectivity.NeighborsOfVertex[vertex].size());
    slide -= slide.dot(normal) * normal;
    const double most = LongestSlide * scale;
    if (slide.norm() > most)
    {
      slide *= most / slide.norm();
    }
    return x + slide + height * scale * normal;
  }

private:
  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const std::vector<double>& Scales;
  double LikeDistance;
  NearVertices Near;
};
}

std::vector<Vec3> DenoisedPoints(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<double>& scales, const Roughness& roughness, const Monitor& monitor)
{
  const double likeAngle = std::clamp(LikeAngle + roughness.Angle, LeastLike, MostLike);
  std::vector<Vec3> points = mesh.Points;
  std::vector<Vec3> next(points.size());
  for (int round = 0; round < Rounds; ++round)
  {
    const std::vector<Vec3> normals = VertexNormals(mesh, connectivity, points);
    const bool finished = ParallelFor(mesh.VertexCount(),
      monitor.Part(static_cast<double>(round) / Rounds, (round + 1.0) / Rounds),
      [&](Index begin, Index end)
      {
        Denoiser denoiser(mesh, connectivity, scales, likeAngle);
        for (Index v = begin; v < end; ++v)
        {
          next[v] = denoiser.Moved(v, points, normals);
        }
      });
    if (!finished)
    {
      return {};
    }
    points.swap(next);
  }
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    points[v] = mesh.Points[v] + roughness.Degree * (points[v] - mesh.Points[v]);
  }
  return points;
}
}
