// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Roughness.h"

#include "Core/Geometry.h"
#include "Core/Parallel.h"
#include "HeightField.h"
#include "NearVertices.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
constexpr double Radius = 2.0; // in local scales: as near as a second-order fit has enough points
constexpr std::size_t LeastPoints = 10;
constexpr Index MostProbes = 4000;

/// Where normals of vertices turn by more than this from their mean, in degrees, there is an edge:
/// noise of a tenth of the edge length turns them by half as much.
constexpr double EdgeTurn = 25.0;

/// The share of the other probes that are surely away from edges.
constexpr double SmoothShare = 0.2;

/// Fewer probes than this say nothing.
constexpr std::size_t LeastProbes = 20;

// In local scales. Measured: contours of exact and of blurred distances up to .0027 (32 to 128
// cells), segmentations .0062 to .017, noise of a tenth of the edge length from .058.
constexpr double SmoothHeight = 0.0035;
constexpr double RoughHeight = 0.005;
constexpr double TerraceHeight = 0.02;
constexpr double NoiseHeight = 0.05;

struct Probe
{
  double Height = -1.0; // none
  double Angle = 0.0;
};

class Prober
{
public:
  Prober(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , Scales(scales)
  {
  }

  Probe At(Index vertex)
  {
    const Mesh& mesh = this->TheMesh;
    const Vec3& x = mesh.Points[vertex];
    const std::vector<Index>& near = this->Near.Gather(
      mesh.Points, this->TheConnectivity, vertex, x, Radius * this->Scales[vertex]);
    if (near.size() < LeastPoints || this->TurnAround(near) > EdgeTurn)
    {
      return {};
    }
    const TangentFrame frame(x, this->MeanNormal.normalized(), this->Scales[vertex]);
    HeightField field;
    for (Index v : near)
    {
      field.Add(frame.Local(mesh.Points[v]), 1.0);
    }
    const HeightField::Vec6 c = field.Solve(1e-9);
    double heights = 0.0;
    for (Index v : near)
    {
      const Vec3 p = frame.Local(mesh.Points[v]);
      const double off = p[2] - c.dot(HeightField::Basis(p[0], p[1]));
      heights += off * off;
    }
    double angles = 0.0, areas = 0.0;
    for (Index t : this->TheConnectivity.TrianglesOfVertex[vertex])
    {
      const Corners corners(mesh, t);
      const Vec3 area = corners.AreaVector();
      const Vec3 p = frame.Local(corners.Centroid());
      const Vec3 expected = frame.N - (c[1] + 2.0 * c[3] * p[0] + c[4] * p[1]) * frame.U -
        (c[2] + c[4] * p[0] + 2.0 * c[5] * p[1]) * frame.W;
      const double angle = std::atan2(area.cross(expected).norm(), area.dot(expected));
      angles += area.norm() * angle * angle;
      areas += area.norm();
    }
    return { std::sqrt(heights / near.size()),
      areas > 0.0 ? std::sqrt(angles / areas) * 180.0 / Pi : 0.0 };
  }

private:
  /// Sets the mean normal. The largest angle of a vertex's normal with it, in degrees.
  double TurnAround(const std::vector<Index>& vertices)
  {
    this->Normals.clear();
    this->MeanNormal = Vec3::Zero();
    for (Index v : vertices)
    {
      this->Normals.push_back(AreaVectorAround(this->TheMesh, this->TheConnectivity, v));
      this->MeanNormal += this->Normals.back();
    }
    double largest = 0.0;
    for (const Vec3& own : this->Normals)
    {
      largest = std::max(
        largest, std::atan2(own.cross(this->MeanNormal).norm(), own.dot(this->MeanNormal)));
    }
    return largest * 180.0 / Pi;
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const std::vector<double>& Scales;
  NearVertices Near;
  std::vector<Vec3> Normals; // of the vertices near, and of all of them
  Vec3 MeanNormal;
};

/// 0 up to `from`, 1 from `to` on.
double ShareOfWay(double value, double from, double to)
{
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

double Quantile(std::vector<double>& values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}
}

Roughness MeasureRoughness(
  const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales)
{
  const Index step = mesh.VertexCount() / MostProbes + 1;
  std::vector<Probe> probes((mesh.VertexCount() + step - 1) / step);
  ParallelFor(static_cast<Index>(probes.size()),
    [&](Index begin, Index end)
    {
      Prober prober(mesh, connectivity, scales);
      for (Index i = begin; i < end; ++i)
      {
        probes[i] = prober.At(i * step);
      }
    });
  std::vector<double> heights, angles;
  for (const Probe& probe : probes)
  {
    if (probe.Height >= 0.0)
    {
      heights.push_back(probe.Height);
      angles.push_back(probe.Angle);
    }
  }
  Roughness roughness;
  if (heights.size() >= LeastProbes)
  {
    roughness.Height = Quantile(heights, SmoothShare);
    roughness.Angle = Quantile(angles, SmoothShare);
    roughness.Degree = ShareOfWay(roughness.Height, SmoothHeight, RoughHeight);
    roughness.Noise = ShareOfWay(roughness.Height, TerraceHeight, NoiseHeight);
  }
  return roughness;
}
}
