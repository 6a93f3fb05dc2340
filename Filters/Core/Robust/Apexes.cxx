// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Apexes.h"

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

  /// Gathers the connected part of the region at `seed` and the intact vertices around it; false if
  /// it is too large or comes near another part.
  bool Gather(Index seed)
  {
    this->Members.assign(1, seed);
    this->Ring[seed] = 0;
    this->Rim.clear();
    for (std::size_t next = 0; next < this->Members.size(); ++next)
    {
      for (Index n : this->Around.TheConnectivity.NeighborsOfVertex[this->Members[next]])
      {
        if (this->Region[n] && this->Ring[n] < 0)
        {
          this->Ring[n] = 0;
          this->Members.push_back(n);
        }
      }
    }
    if (this->Members.size() > MostVertices)
    {
      return false;
    }
    std::vector<Index> reached = this->Members;
    bool alone = true;
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
    for (std::size_t i = this->Members.size(); i < reached.size(); ++i)
    {
      if (this->Ring[reached[i]] >= NearestRing)
      {
        this->Rim.push_back(reached[i]);
      }
      this->Ring[reached[i]] = -1;
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

  const std::vector<Index>& TheMembers() const { return this->Members; }

private:
  const Surroundings& Around;
  const Flags& Region;
  std::vector<int> Ring; // edges away from the members; -1 for what is not reached
  std::vector<Index> Members;
  std::vector<Index> Rim;
};
}

std::vector<Apex> FindApexes(const Surroundings& around, const Flags& region, Labelling& labelling)
{
  std::vector<Apex> apexes;
  ApexFinder finder(around, region);
  Flags seen(region.size(), 0);
  for (Index v = 0; v < around.TheMesh.VertexCount(); ++v)
  {
    if (!region[v] || seen[v])
    {
      continue;
    }
    const bool alone = finder.Gather(v);
    for (Index member : finder.TheMembers())
    {
      seen[member] = 1;
    }
    Apex apex{ NoIndex, Vec3::Zero(), {} };
    if (!alone || !finder.FindTip(apex))
    {
      continue;
    }
    const Index label = labelling.FirstApexLabel + static_cast<Index>(apexes.size());
    for (Index member : finder.TheMembers())
    {
      labelling.Labels[member] = label;
      labelling.Sides[labelling.SidesOf[member]].clear();
    }
    apex.Members = finder.TheMembers();
    apexes.push_back(apex);
  }
  return apexes;
}
}
