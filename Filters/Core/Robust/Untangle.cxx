// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Untangle.h"

#include "Clusters.h"
#include "Core/Flagged.h"
#include "Core/Parallel.h"
#include "Core/SortUnique.h"
#include "Mender.h"
#include "Overturned.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace arris
{
namespace
{
/// Triangles under this quality are mended.
constexpr double BadQuality = 0.01;

/// What has not been mended in so many rounds will not be, and others make way for it all the time.
constexpr int MostTries = 6;
constexpr int RoundsAlone = 2;

class Untangler
{
public:
  Untangler(const Mesh& mesh, const Connectivity& connectivity, const std::vector<double>& scales,
    int order, Placement& placement)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , Scales(scales)
    , Order(order)
    , ThePlacement(placement)
    , Tries(mesh.Triangles.size(), 0)
    , TheClusters(connectivity)
  {
  }

  std::vector<Index> Run(std::vector<Index> suspects)
  {
    for (int round = 0; !suspects.empty(); ++round)
    {
      // What single vertices could not mend in a few rounds may want room made by the ones around.
      const std::vector<Index> bad = Those(suspects, [this](Index t) { return this->IsBad(t); });
      suspects = this->MendAll(this->TryAgain(bad), round >= RoundsAlone);
    }
    SortUnique(this->Moved);
    return std::move(this->Moved);
  }

private:
  /// Those of the triangles that have not been tried too often yet.
  std::vector<Index> TryAgain(const std::vector<Index>& bad)
  {
    std::vector<Index> again;
    std::copy_if(bad.begin(), bad.end(), std::back_inserter(again),
      [this](Index t) { return this->Tries[t]++ < MostTries; });
    return again;
  }

  bool IsBad(Index t) const
  {
    return this->ThePlacement.LabelOf(t) != NoIndex &&
      (this->ThePlacement.Quality(t) < BadQuality ||
        IsOverturned(this->TheMesh, this->TheConnectivity, this->ThePlacement.AllPoints(), t));
  }

  /// Mends the triangles, cluster by cluster. Returns those that are to be looked at next.
  std::vector<Index> MendAll(const std::vector<Index>& bad, bool stuck)
  {
    this->TheClusters.Clear();
    for (Index t : bad)
    {
      this->TheClusters.Add(this->ThatMayMoveFor(t));
    }
    const Rows clusters = this->TheClusters.Find();
    std::vector<std::vector<Index>> next(clusters.size()), moved(clusters.size());
    ParallelFor(clusters.size(),
      [&](Index begin, Index end)
      {
        Mender mender(this->TheMesh, this->TheConnectivity, this->Scales, this->ThePlacement);
        for (Index c = begin; c < end; ++c)
        {
          this->Mend(bad, clusters[c], stuck, mender);
          next[c] = this->NextOf(mender, stuck);
          moved[c] = mender.Moved;
        }
      });
    std::vector<Index> suspects;
    for (const std::vector<Index>& of : next)
    {
      suspects.insert(suspects.end(), of.begin(), of.end());
    }
    for (const std::vector<Index>& of : moved)
    {
      this->Moved.insert(this->Moved.end(), of.begin(), of.end());
    }
    SortUnique(suspects);
    return suspects;
  }

  /// The vertices next to a triangle, and those of its pocket.
  std::vector<Index> ThatMayMoveFor(Index t) const
  {
    std::vector<Index> vertices;
    for (Index v : this->TheMesh.Triangles[t])
    {
      const IndexSpan neighbors = this->TheConnectivity.NeighborsOfVertex[v];
      vertices.insert(vertices.end(), neighbors.begin(), neighbors.end());
    }
    for (Index of : PocketOf(
           this->TheMesh, this->TheConnectivity, this->ThePlacement, t, [](Index) { return true; }))
    {
      const Triangle& corners = this->TheMesh.Triangles[of];
      vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    SortUnique(vertices);
    return vertices;
  }

  /// Mends one cluster of the bad triangles: what there is to be seen and moved is its own.
  void Mend(const std::vector<Index>& bad, IndexSpan cluster, bool stuck, Mender& mender) const
  {
    mender.Moved.clear();
    mender.Tried.clear();
    std::vector<Index> own;
    std::transform(
      cluster.begin(), cluster.end(), std::back_inserter(own), [&](Index i) { return bad[i]; });
    std::vector<Index> vertices = this->ThePlacement.DamagedOf(own);
    if (stuck)
    {
      vertices = this->ThePlacement.DamagedAround(vertices);
    }
    for (Index v : this->Shuffled(vertices))
    {
      mender.Slide(v);
    }
    const auto isOwn = [&](Index t)
    {
      const Triangle& corners = this->TheMesh.Triangles[t];
      return std::all_of(corners.begin(), corners.end(),
        [&](Index v) { return this->TheClusters.MayMove(v, cluster[0]); });
    };
    own.erase(std::remove_if(own.begin(), own.end(), [this](Index t) { return !this->IsBad(t); }),
      own.end());
    for (Index t : this->Shuffled(own))
    {
      mender.Relabel(t, isOwn);
    }
  }

  /// The items as they are, or in another order. By places, not numbers: so what is in no triangle
  /// has no part in it.
  std::vector<Index> Shuffled(const std::vector<Index>& items) const
  {
    if (this->Order == 0)
    {
      return items;
    }
    // Multiples of the golden ratio are spread evenly, those of its multiples in another order.
    constexpr std::uint32_t Golden = 2654435769U;
    const auto keyOf = [&](std::size_t place)
    {
      const auto spread = static_cast<std::uint32_t>((2 * this->Order + 1) * (place + 1)) * Golden;
      return spread ^ spread >> 15;
    };
    std::vector<std::pair<std::uint32_t, std::size_t>> places;
    for (std::size_t place = 0; place < items.size(); ++place)
    {
      places.emplace_back(keyOf(place), place);
    }
    std::sort(places.begin(), places.end());
    std::vector<Index> shuffled;
    shuffled.reserve(places.size());
    for (const auto& place : places)
    {
      shuffled.push_back(items[place.second]);
    }
    return shuffled;
  }

  /// What had no better place, and none has moved near it, will have none when all make way,
  /// either.
  std::vector<Index> NextOf(const Mender& mender, bool stuck) const
  {
    if (!stuck)
    {
      return TrianglesAround(this->TheConnectivity, mender.Tried);
    }
    return TrianglesAround(this->TheConnectivity, this->ThePlacement.DamagedAround(mender.Moved));
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const std::vector<double>& Scales;
  const int Order;
  Placement& ThePlacement;
  std::vector<int> Tries; // of each triangle
  Clusters TheClusters;
  std::vector<Index> Moved; // at some time
};
}

std::vector<Index> Untangle(const Mesh& mesh, const Connectivity& connectivity,
  const std::vector<double>& scales, std::vector<Index> triangles, int order, Placement& placement)
{
  return Untangler(mesh, connectivity, scales, order, placement).Run(std::move(triangles));
}
}
