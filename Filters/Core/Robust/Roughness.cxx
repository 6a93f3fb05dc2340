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

/// The share of probes that are surely away from edges, on whatever part.
constexpr double SmoothShare = 0.2;

// In local scales. Measured at 64^3: contours of exact distances up to .0020, blended ones up to
// .0062, segmentations .0069 to .018, noise of a tenth of the edge length .062 to .076.
constexpr double SmoothHeight = 0.0055;
constexpr double RoughHeight = 0.0075;

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
    Vec3 normal = Vec3::Zero();
    for (Index v : near)
    {
      for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
      {
        normal += Corners(mesh, t).AreaVector();
      }
    }
    if (near.size() < LeastPoints || !(normal.norm() > 0.0))
    {
      return {};
    }
    const TangentFrame frame(x, normal.normalized(), this->Scales[vertex]);
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
  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const std::vector<double>& Scales;
  NearVertices Near;
};

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
  if (!heights.empty())
  {
    roughness.Height = Quantile(heights, SmoothShare);
    roughness.Angle = Quantile(angles, SmoothShare);
    roughness.Degree =
      std::clamp((roughness.Height - SmoothHeight) / (RoughHeight - SmoothHeight), 0.0, 1.0);
  }
  return roughness;
}
}
