// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Apexes.h"

#include "ConeTip.h"
#include "Core/Flagged.h"
#include "Mixed.h"
#include "Placement.h"

#include <limits>
#include <utility>

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

/// Planes that meet pass this near to the tip (root mean square, in local scales); those of a rough
/// mesh less near.
constexpr double MeetingDistance = 0.15;
constexpr double RoughMeetingDistance = 0.4;

/// A blur has moved what is around the tip as well; how that fades tells by how much. It leaves no
/// plane farther from the tip than this, in local scales: what looks like more is a dome.
constexpr int FarthestBlurredRing = 7;
constexpr double MostBlur = 1.0;

/// The mean normal of planes that close around a tip is no longer than this.
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
      if (this->Ring[v] == this->LastRing())
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
    const TangentPlanes planes = this->PlanesOfRim();
    if (!Close(planes))
    {
      return false;
    }
    const ConeTip tip = this->Around.IsBlurred() ? FindBlurredConeTip(planes) : FindConeTip(planes);
    apex.Tip = tip.Point;
    this->PutInPlace(planes, apex);
    const double scale = this->Around.Scales[this->Members.front()];
    const double move = (apex.Tip - this->Around.TheMesh.Points[apex.Vertex]).norm();
    const double misfit = Mixed(MeetingDistance, RoughMeetingDistance, this->Around.Rough.Degree);
    return move <= LongestMoveOf(this->Around.Rounding) * scale && tip.Misfit <= misfit * scale &&
      tip.Blur <= MostBlur * scale;
  }

private:
  int LastRing() const { return this->Around.IsBlurred() ? FarthestBlurredRing : FarthestRing; }

  TangentPlanes PlanesOfRim() const
  {
    TangentPlanes planes;
    for (Index v : this->Rim)
    {
      planes.Points.push_back(this->Around.TheMesh.Points[v]);
      planes.Normals.push_back(this->Around.TheFaces.VertexNormals[v]);
    }
    return planes;
  }

  /// The nearest vertex goes to the tip, the others on the cone if a blur has moved them.
  void PutInPlace(const TangentPlanes& planes, Apex& apex) const
  {
    double least = std::numeric_limits<double>::max();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < this->Members.size(); ++i)
    {
      const Vec3& point = this->Around.TheMesh.Points[this->Members[i]];
      apex.Places.push_back(this->Around.IsBlurred() ? OnCone(planes, apex.Tip, point) : point);
      if ((apex.Tip - point).norm() < least)
      {
        least = (apex.Tip - point).norm();
        nearest = i;
      }
    }
    apex.Vertex = this->Members[nearest];
    apex.Places[nearest] = apex.Tip;
  }

  /// Whether the planes close around a tip. Around a dent in a nearly flat face they do not.
  static bool Close(const TangentPlanes& planes)
  {
    return SumOfNormals(planes).norm() <=
      LongestMeanNormal * static_cast<double>(planes.Normals.size());
  }

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
      Apex apex{ NoIndex, Vec3::Zero(), members, {} };
      if (finder.Gather(members) && finder.FindTip(apex))
      {
        apexes.push_back(std::move(apex));
      }
    });
  return apexes;
}
}
