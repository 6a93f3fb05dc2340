// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Apexes.h"

#include "Core/Flagged.h"
#include "Core/Predictor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris
{
namespace
{
/// A tip's region is not larger than this; an edge's is longer.
constexpr std::size_t MostVertices = 200;

/// The intact vertices up to this many edges away are asked for their planes. Those next to the
/// region are not: its triangles are in their normals.
constexpr int NearestRing = 2;
constexpr int FarthestRing = 3;
constexpr std::size_t LeastPlanes = 8;

/// Planes that meet pass this near to the tip (root mean square, in local scales).
constexpr double MeetingDistance = 0.15;

/// The farthest a tip may be from the mesh, in local scales.
constexpr double FarthestTip = 3.25;

/// The planes must close around the tip: their mean normal is no longer than this. A dent in a
/// nearly flat face is no tip.
constexpr double LongestMeanNormal = 0.9;

class ApexFinder
{
public:
  ApexFinder(const Surroundings& around, const Flags& region)
    : Around(around)
    , Region(region)
    , Ring(region.size(), -1)
  {
  }

  /// Takes a connected part of the region and gathers the intact vertices around it; false if it
  /// is too large, comes near another part, or is on a boundary and not surrounded.
  bool Gather(const std::vector<Index>& members)
  {
    if (members.size() > MostVertices)
    {
      return false;
    }
    this->Members = members;
    this->Rim.clear();
    bool alone = true;
    for (Index v : members)
    {
      this->Ring[v] = 0;
      alone = alone && !this->Around.TheConnectivity.OnBoundary[v];
    }
    std::vector<Index> reached = this->Members;
    for (std::size_t next = 0; next < reached.size(); ++next)
    {
      const Index v = reached[next];
      if (this->Ring[v] == FarthestRing)
      {
        break;
      }
      for (Index n : this->Around.TheConnectivity.NeighborsOfVertex[v])
      {
        alone = alone && !(this->Region[n] && this->Ring[n] != 0);
        if (this->Ring[n] < 0)
        {
          this->Ring[n] = this->Ring[v] + 1;
          reached.push_back(n);
        }
      }
    }
    for (Index v : reached)
    {
      if (this->Ring[v] >= NearestRing)
      {
        this->Rim.push_back(v);
      }
      this->Ring[v] = -1;
    }
    return alone && this->Rim.size() >= LeastPlanes;
  }

  /// Where the planes around meet; false if they do not.
  bool FindTip(Apex& apex) const
  {
    const Vec3& first = this->Around.TheMesh.Points[this->Members.front()];
    const double scale = this->Around.Scales[this->Members.front()];
    Predictor predictor(first);
    Vec3 sum = Vec3::Zero();
    for (Index v : this->Rim)
    {
      const Vec3& normal = this->Around.TheFaces.VertexNormals[v];
      predictor.AddPlane(this->Around.TheMesh.Points[v], normal, 1.0);
      sum += normal;
    }
    const double planes = static_cast<double>(this->Rim.size());
    if (sum.norm() > LongestMeanNormal * planes)
    {
      return false;
    }
    apex.Tip = predictor.Position(std::numeric_limits<double>::max());
    double squares = 0.0;
    for (Index v : this->Rim)
    {
      const double off =
        (apex.Tip - this->Around.TheMesh.Points[v]).dot(this->Around.TheFaces.VertexNormals[v]);
      squares += off * off;
    }
    double least = std::numeric_limits<double>::max();
    for (Index v : this->Members)
    {
      const double distance = (apex.Tip - this->Around.TheMesh.Points[v]).norm();
      if (distance < least)
      {
        least = distance;
        apex.Vertex = v;
      }
    }
    return least <= FarthestTip * scale && std::sqrt(squares / planes) <= MeetingDistance * scale;
  }

private:
  const Surroundings& Around;
  const Flags& Region;
  std::vector<int> Ring; // edges away from the members; -1 for what is not reached
  std::vector<Index> Members;
  std::vector<Index> Rim;
};
}

std::vector<Apex> FindApexes(const Surroundings& around, const Flags& region)
{
  std::vector<Apex> apexes;
  ApexFinder finder(around, region);
  ForEachGroup(around.TheConnectivity, region, 1,
    [&](const std::vector<Index>& members)
    {
      Apex apex{ NoIndex, Vec3::Zero(), members };
      if (finder.Gather(members) && finder.FindTip(apex))
      {
        apexes.push_back(std::move(apex));
      }
    });
  return apexes;
}
}
