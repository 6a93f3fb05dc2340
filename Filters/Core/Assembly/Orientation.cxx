// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Orientation.h"

#include <map>
#include <utility>

namespace arris
{
namespace
{
/// Whether a triangle runs along its edge k from the lower vertex to the higher.
bool Ascends(const Triangle& triangle, int k)
{
  return triangle[k] < triangle[Next(k)];
}

class Orienter
{
public:
  Orienter(Mesh& mesh, const std::vector<Index>& patchOf, Index patchCount,
    const Unfilled<std::array<Index, 3>>& uncut, Connectivity& connectivity)
    : TheMesh(mesh)
    , PatchOf(patchOf)
    , Uncut(uncut)
    , TheConnectivity(connectivity)
    , Turned(mesh.Triangles.size(), 0)
    , Reached(mesh.Triangles.size(), 0)
    , OneSided(static_cast<std::size_t>(patchCount), 0)
    , PatchTurned(static_cast<std::size_t>(patchCount), 0)
  {
  }

  Oriented Run()
  {
    for (Index t = 0; t < this->TheMesh.TriangleCount(); ++t)
    {
      if (!this->Reached[t])
      {
        this->OrientFrom(t);
      }
    }
    this->OrientPatchesAlike();
    Oriented oriented;
    for (Index t = 0; t < this->TheMesh.TriangleCount(); ++t)
    {
      if (this->Turned[t] != this->PatchTurned[this->PatchOf[t]])
      {
        std::swap(this->TheMesh.Triangles[t][1], this->TheMesh.Triangles[t][2]);
        std::swap(this->TheConnectivity.AcrossEdge[t][0], this->TheConnectivity.AcrossEdge[t][2]);
        ++oriented.FlippedTriangles;
      }
    }
    for (unsigned char oneSided : this->OneSided)
    {
      oriented.OneSidedPatches += oneSided;
    }
    return oriented;
  }

private:
  /// The edge of `triangle` with the vertices of edge k of `other`.
  int SameEdge(Index triangle, Index other, int k) const
  {
    const Triangle& corners = this->TheMesh.Triangles[triangle];
    const Index a = this->TheMesh.Triangles[other][k];
    const Index b = this->TheMesh.Triangles[other][Next(k)];
    for (int edge = 0; edge < 2; ++edge)
    {
      if ((corners[edge] == a && corners[Next(edge)] == b) ||
        (corners[edge] == b && corners[Next(edge)] == a))
      {
        return edge;
      }
    }
    return 2;
  }

  /// Whether the triangles as given run along the edge in the same direction.
  bool AreAgainst(Index a, int edgeOfA, Index b, int edgeOfB) const
  {
    return Ascends(this->TheMesh.Triangles[a], edgeOfA) ==
      Ascends(this->TheMesh.Triangles[b], edgeOfB);
  }

  void OrientFrom(Index seed)
  {
    std::vector<Index> front(1, seed);
    this->Reached[seed] = 1;
    for (std::size_t next = 0; next < front.size(); ++next)
    {
      const Index t = front[next];
      for (int k = 0; k < 3; ++k)
      {
        const Index beyond = this->TheConnectivity.AcrossEdge[t][k];
        if (beyond == NoIndex)
        {
          continue;
        }
        const int edge = this->SameEdge(beyond, t, k);
        const unsigned char turned =
          this->AreAgainst(t, k, beyond, edge) ? !this->Turned[t] : this->Turned[t];
        if (!this->Reached[beyond])
        {
          this->Reached[beyond] = 1;
          this->Turned[beyond] = turned;
          front.push_back(beyond);
        }
        else if (this->Turned[beyond] != turned)
        {
          this->OneSided[this->PatchOf[t]] = 1;
          this->TheConnectivity.AcrossEdge[t][k] = NoIndex;
          this->TheConnectivity.AcrossEdge[beyond][edge] = NoIndex;
        }
      }
    }
  }

  /// For each pair of patches that meet without a third, on how many more edges they are wound
  /// alike than against each other.
  std::vector<std::map<Index, Index>> Votes() const
  {
    std::vector<std::map<Index, Index>> votes(this->OneSided.size());
    for (Index t = 0; t < this->TheMesh.TriangleCount(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index beyond = this->Uncut[t][k];
        if (beyond == NoIndex || this->PatchOf[beyond] == this->PatchOf[t])
        {
          continue;
        }
        const int edge = this->SameEdge(beyond, t, k);
        if (this->Uncut[beyond][edge] == t) // and no third
        {
          const bool against =
            this->AreAgainst(t, k, beyond, edge) != (this->Turned[t] != this->Turned[beyond]);
          votes[this->PatchOf[t]][this->PatchOf[beyond]] += against ? -1 : 1;
        }
      }
    }
    return votes;
  }

  void OrientPatchesAlike()
  {
    const std::vector<std::map<Index, Index>> votes = this->Votes();
    std::vector<Index> turnedIn(votes.size(), 0), trianglesIn(votes.size(), 0);
    for (Index t = 0; t < this->TheMesh.TriangleCount(); ++t)
    {
      ++trianglesIn[this->PatchOf[t]];
      turnedIn[this->PatchOf[t]] += this->Turned[t];
    }
    Flags reached(votes.size(), 0);
    for (std::size_t seed = 0; seed < votes.size(); ++seed)
    {
      if (reached[seed])
      {
        continue;
      }
      std::vector<Index> group(1, static_cast<Index>(seed));
      reached[seed] = 1;
      Index turned = 0, triangles = 0;
      for (std::size_t next = 0; next < group.size(); ++next)
      {
        const Index patch = group[next];
        triangles += trianglesIn[patch];
        turned += this->PatchTurned[patch] ? trianglesIn[patch] - turnedIn[patch] : turnedIn[patch];
        for (const auto& [other, vote] : votes[patch])
        {
          if (!reached[other])
          {
            reached[other] = 1;
            this->PatchTurned[other] =
              vote < 0 ? !this->PatchTurned[patch] : this->PatchTurned[patch];
            group.push_back(other);
          }
        }
      }
      if (2 * turned > triangles)
      {
        for (Index patch : group)
        {
          this->PatchTurned[patch] = !this->PatchTurned[patch];
        }
      }
    }
  }

  Mesh& TheMesh;
  const std::vector<Index>& PatchOf;
  const Unfilled<std::array<Index, 3>>& Uncut;
  Connectivity& TheConnectivity;
  Flags Turned; // relative to how triangles are given
  Flags Reached;
  Flags OneSided; // by patch
  Flags PatchTurned; // by patch, with all its triangles, on top of that
};
}

Oriented OrientPatches(Mesh& mesh, const std::vector<Index>& patchOf, Index patchCount,
  const Unfilled<std::array<Index, 3>>& uncut, Connectivity& connectivity)
{
  return Orienter(mesh, patchOf, patchCount, uncut, connectivity).Run();
}
}
