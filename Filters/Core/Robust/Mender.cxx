// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Mender.h"

#include "Core/Geometry.h"
#include "Core/SortUnique.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace arris
{
namespace
{
/// A change that gains less is one of rounding.
constexpr double LeastGain = 1e-6;

bool IsOnRidge(const Placement& placement, Index v)
{
  return placement.IsDamaged(v) && placement.SheetsOf(v).size() > 1;
}
}

std::vector<Index> PocketOf(const Mesh& mesh, const Connectivity& connectivity,
  const Placement& placement, Index bad, const std::function<bool(Index triangle)>& mayBe)
{
  constexpr std::size_t Largest = 24;
  const Index label = placement.LabelOf(bad);
  std::vector<Index> pocket(1, bad);
  for (std::size_t next = 0; next < pocket.size(); ++next)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Triangle& corners = mesh.Triangles[pocket[next]];
      const Index beyond = connectivity.AcrossEdge[pocket[next]][k];
      if (beyond == NoIndex || placement.LabelOf(beyond) != label ||
        (IsOnRidge(placement, corners[k]) && IsOnRidge(placement, corners[Next(k)])) ||
        std::find(pocket.begin(), pocket.end(), beyond) != pocket.end())
      {
        continue;
      }
      if (pocket.size() == Largest || !mayBe(beyond))
      {
        return {};
      }
      pocket.push_back(beyond);
    }
  }
  return pocket;
}

void Mender::Slide(Index v)
{
  Vec3 along = Vec3::Zero();
  const int freedom = this->ThePlacement.Freedom(v, along);
  const IndexSpan around = this->TheConnectivity.TrianglesOfVertex[v];
  if (freedom == 0 || around.size() > LargestFan)
  {
    return;
  }
  this->Fan.Take(v);
  const Vec3 start = this->ThePlacement.PointOf(v);
  Vec3 best = start;
  double bestWorth = this->Fan.Now() + LeastGain;
  const double mostWorth = MostWorth(around.size());
  const auto attempt = [&](const Vec3& target)
  {
    if (bestWorth > mostWorth - LeastGain)
    {
      return;
    }
    const Vec3 point = this->ThePlacement.Held(v, target);
    this->ThePlacement.SetPoint(v, point);
    const double worth = this->Fan.Now(bestWorth);
    this->ThePlacement.SetPoint(v, start);
    if (worth > bestWorth)
    {
      bestWorth = worth;
      best = point;
    }
  };
  Vec3 center = Vec3::Zero();
  const IndexSpan neighbors = this->TheConnectivity.NeighborsOfVertex[v];
  for (Index n : neighbors)
  {
    center += this->ThePlacement.PointOf(n);
  }
  center /= neighbors.size();
  attempt(center);
  attempt(0.5 * (center + start));
  const Vec3 normal = this->ThePlacement.SheetsOf(v)[0]->Normal(start);
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 w = normal.cross(u);
  for (const double step : { 0.05, 0.15, 0.4, 0.8 })
  {
    const double length = step * this->Scales[v];
    if (freedom == 1)
    {
      attempt(start + length * along);
      attempt(start - length * along);
      continue;
    }
    for (int k = 0; k < 8; ++k)
    {
      const double angle = k * Pi / 4.0;
      attempt(start + length * (std::cos(angle) * u + std::sin(angle) * w));
    }
  }
  if (best != start)
  {
    this->ThePlacement.SetPoint(v, best);
    this->Tried.push_back(v);
    this->Moved.push_back(v);
  }
}

void Mender::Relabel(Index bad, const std::function<bool(Index triangle)>& mayBeInPocket)
{
  for (Index v : this->TheMesh.Triangles[bad])
  {
    if (this->TheConnectivity.TrianglesOfVertex[v].size() > LargestFan)
    {
      return;
    }
  }
  const std::vector<Index> labels = this->LabelsAround(bad);
  Best best{ LeastGain, NoIndex, {} };
  for (const std::vector<Index>& group : this->GroupsWith(bad, mayBeInPocket))
  {
    this->TryLabels(group, labels, best);
  }
  if (best.Label != NoIndex)
  {
    const std::vector<Index> vertices = this->ThePlacement.DamagedOf(best.Group);
    this->Apply(best.Group, best.Label, vertices);
    this->Tried.insert(this->Tried.end(), vertices.begin(), vertices.end());
    this->Moved.insert(this->Moved.end(), vertices.begin(), vertices.end());
  }
}

/// Those of its neighbours' labels that it might bear as well, ascending.
std::vector<Index> Mender::LabelsAround(Index bad) const
{
  const Index own = this->ThePlacement.LabelOf(bad);
  std::vector<Index> labels;
  for (Index v : this->TheMesh.Triangles[bad])
  {
    for (Index t : this->TheConnectivity.TrianglesOfVertex[v])
    {
      const Index label = this->ThePlacement.LabelOf(t);
      if (label != NoIndex && label != own && // labels stay within a patch
        AreOnePatch(this->TheConnectivity, t, bad))
      {
        labels.push_back(label);
      }
    }
  }
  SortUnique(labels);
  return labels;
}

/// What may be relabelled with the triangle: itself, a sector at one of its corners, its pocket;
/// each once, and only if no vertex is intact: such a one stays on its own face.
std::vector<std::vector<Index>> Mender::GroupsWith(
  Index bad, const std::function<bool(Index triangle)>& mayBeInPocket) const
{
  std::vector<std::vector<Index>> groups;
  const auto add = [&](std::vector<Index> group)
  {
    std::sort(group.begin(), group.end());
    if (!group.empty() && this->IsAllDamaged(group) &&
      std::find(groups.begin(), groups.end(), group) == groups.end())
    {
      groups.push_back(std::move(group));
    }
  };
  add({ bad });
  if (groups.empty())
  {
    return groups; // as it is in all others, too
  }
  for (Index v : this->TheMesh.Triangles[bad])
  {
    add(this->Sector(v, this->ThePlacement.LabelOf(bad)));
  }
  add(PocketOf(this->TheMesh, this->TheConnectivity, this->ThePlacement, bad, mayBeInPocket));
  return groups;
}

/// The triangles of a fan around `v` that bear one label.
std::vector<Index> Mender::Sector(Index v, Index label) const
{
  const IndexSpan around = this->TheConnectivity.TrianglesOfVertex[v];
  std::vector<Index> sector;
  std::copy_if(around.begin(), around.end(), std::back_inserter(sector),
    [&](Index t) { return this->ThePlacement.LabelOf(t) == label; });
  return sector;
}

bool Mender::IsAllDamaged(const std::vector<Index>& group) const
{
  return std::all_of(group.begin(), group.end(),
    [this](Index t)
    {
      const Triangle& corners = this->TheMesh.Triangles[t];
      return std::all_of(corners.begin(), corners.end(),
        [this](Index v) { return this->ThePlacement.IsDamaged(v); });
    });
}

/// What each label would gain for the group; everything is put back.
void Mender::TryLabels(
  const std::vector<Index>& group, const std::vector<Index>& labels, Best& best)
{
  const std::vector<Index> vertices = this->ThePlacement.DamagedOf(group);
  const std::vector<Index> triangles = TrianglesAround(this->TheConnectivity, vertices);
  const double before = this->WorthOf(triangles);
  const double most = MostWorth(triangles.size());
  const std::size_t moved = this->Moved.size();
  std::vector<Vec3> points;
  points.reserve(vertices.size());
  for (Index v : vertices)
  {
    points.push_back(this->ThePlacement.PointOf(v));
  }
  const Index own = this->ThePlacement.LabelOf(group.front());
  for (Index label : labels)
  {
    if (most - before <= best.Gain)
    {
      break;
    }
    this->Apply(group, label, vertices); // which does not ask what the one before has left
    const double gain = this->WorthOf(triangles) - before;
    if (gain > best.Gain)
    {
      best = { gain, label, group };
    }
  }
  for (Index t : group)
  {
    this->ThePlacement.SetLabel(t, own);
  }
  for (Index v : vertices)
  {
    this->ThePlacement.Place(v);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    this->ThePlacement.SetPoint(vertices[i], points[i]);
  }
  this->Moved.resize(moved);
}

void Mender::Apply(const std::vector<Index>& group, Index label, const std::vector<Index>& vertices)
{
  for (Index t : group)
  {
    this->ThePlacement.SetLabel(t, label);
  }
  for (Index v : vertices)
  {
    this->ThePlacement.Place(v);
  }
  for (Index v : vertices)
  {
    this->Slide(v);
  }
}

double Mender::WorthOf(const std::vector<Index>& triangles) const
{
  return arris::WorthOf(this->TheMesh, this->TheConnectivity, this->ThePlacement,
    IndexSpan(triangles.data(), triangles.data() + triangles.size()));
}
}
