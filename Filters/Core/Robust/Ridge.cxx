// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Ridge.h"

#include "Core/Geometry.h"
#include "Core/Parallel.h"
#include "MeetSheets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris
{
namespace
{
class RidgeFinder
{
public:
  RidgeFinder(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
    const Labelling& labelling, const RightAlready& right)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , TheFaces(faces)
    , TheLabelling(labelling)
    , Right(right)
    , Cover(mesh.Points.size(), 0)
  {
  }

  Ridge Find()
  {
    std::vector<Candidate> candidates = this->Candidates();
    for (const Candidate& candidate : candidates)
    {
      this->Cover[candidate.Vertex] = 1;
    }
    for (std::size_t v = 0; v < this->Cover.size(); ++v)
    {
      this->Cover[v] |= this->Right.OnRidge[v]; // and is not let go
    }
    // The farthest from the ridge are let go first, as long as no crossing is left uncovered.
    std::sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b)
      { return a.Distance != b.Distance ? a.Distance > b.Distance : a.Vertex < b.Vertex; });
    for (const Candidate& candidate : candidates)
    {
      const bool needed = std::any_of(candidate.Across.begin(), candidate.Across.end(),
        [this](Index other) { return !this->Cover[other]; });
      if (!needed && !this->Right.OnRidge[candidate.Vertex])
      {
        this->Cover[candidate.Vertex] = 0;
      }
    }
    Ridge ridge;
    ridge.FaceLabels = this->LabelFaces();
    ridge.OnRidge = std::move(this->Cover);
    return ridge;
  }

private:
  struct Candidate
  {
    Index Vertex;
    double Distance; ///< to the ridge of its sheets
    std::vector<Index> Across; ///< the other ends of its crossing edges
  };

  Vec3 NormalOf(Index vertex, Index label, const Vec3& point, Index other) const
  {
    for (Index at : { vertex, other })
    {
      if (const Sheet* sheet = this->TheLabelling.SheetAt(this->TheConnectivity, at, label))
      {
        return sheet->Normal(point);
      }
    }
    return this->TheFaces.VertexNormals[vertex];
  }

  bool Crosses(Index a, Index b) const
  {
    const Index labelA = this->TheLabelling.Labels[a];
    const Index labelB = this->TheLabelling.Labels[b];
    if (labelA == labelB || labelA == NoIndex || labelB == NoIndex ||
      std::max(labelA, labelB) >= this->TheLabelling.FirstApexLabel)
    {
      return false;
    }
    const Vec3 middle = 0.5 * (this->TheMesh.Points[a] + this->TheMesh.Points[b]);
    return this->NormalOf(a, labelA, middle, b).dot(this->NormalOf(b, labelB, middle, a)) <
      std::cos(LeastCrossingAngle * Pi / 180.0);
  }

  double DistanceToRidge(Index vertex, Index other) const
  {
    const Sheet* own =
      this->TheLabelling.SheetAt(this->TheConnectivity, vertex, this->TheLabelling.Labels[vertex]);
    const Sheet* beyond =
      this->TheLabelling.SheetAt(this->TheConnectivity, vertex, this->TheLabelling.Labels[other]);
    if (own == nullptr || beyond == nullptr)
    {
      return std::numeric_limits<double>::max();
    }
    const Vec3& x = this->TheMesh.Points[vertex];
    return (MeetSheets(x, { own, beyond }) - x).norm();
  }

  std::vector<Candidate> Candidates() const
  {
    std::vector<Candidate> candidates;
    for (Index v = 0; v < this->TheMesh.VertexCount(); ++v)
    {
      if (this->TheLabelling.SidesOf[v] != NoIndex)
      {
        candidates.push_back({ v, std::numeric_limits<double>::max(), {} });
      }
    }
    ParallelFor(static_cast<Index>(candidates.size()),
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          this->FindCrossings(candidates[i]);
        }
      });
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                       [](const Candidate& candidate) { return candidate.Across.empty(); }),
      candidates.end());
    return candidates;
  }

  void FindCrossings(Candidate& candidate) const
  {
    const Index v = candidate.Vertex;
    for (Index n : this->TheConnectivity.NeighborsOfVertex[v])
    {
      if (this->Crosses(v, n))
      {
        candidate.Across.push_back(n);
        candidate.Distance = std::min(candidate.Distance, this->DistanceToRidge(v, n));
      }
    }
  }

  std::vector<Index> LabelFaces() const
  {
    std::vector<Index> labels(this->TheMesh.Triangles.size(), NoIndex);
    for (Index t = 0; t < this->TheMesh.TriangleCount(); ++t)
    {
      const Triangle& corners = this->TheMesh.Triangles[t];
      Index label = NoIndex;
      bool touchesRegion = false;
      for (Index v : corners)
      {
        touchesRegion = touchesRegion || this->TheLabelling.SidesOf[v] != NoIndex;
        if (!this->Cover[v] && this->TheLabelling.Labels[v] != NoIndex)
        {
          label = this->Preferred(label, this->TheLabelling.Labels[v]);
        }
      }
      if (touchesRegion)
      {
        labels[t] = label != NoIndex         ? label
          : this->Right.Labels[t] != NoIndex ? this->Right.Labels[t]
                                             : this->LabelBetweenRidges(corners);
      }
    }
    return labels;
  }

  /// Of two labels in one triangle away from all ridges either would do, but for a tip's own.
  Index Preferred(Index a, Index b) const
  {
    const bool apex = std::max(a, b) >= this->TheLabelling.FirstApexLabel;
    return a == NoIndex || apex ? std::max(a, b) : std::min(a, b);
  }

  /// A triangle with all corners on the ridge: the face it lies nearest to.
  Index LabelBetweenRidges(const Triangle& corners) const
  {
    Index best = NoIndex;
    double least = std::numeric_limits<double>::max();
    for (Index candidate : corners)
    {
      const Index label = this->TheLabelling.Labels[candidate];
      double sum = 0.0;
      for (Index v : corners)
      {
        const Sheet* sheet = this->TheLabelling.SheetAt(this->TheConnectivity, v, label);
        sum += sheet ? std::abs(sheet->Distance(this->TheMesh.Points[v])) : 1e30;
      }
      if (sum < least || (sum == least && label < best))
      {
        least = sum;
        best = label;
      }
    }
    return best;
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Faces& TheFaces;
  const Labelling& TheLabelling;
  const RightAlready& Right;
  Flags Cover;
};
}

Ridge FindRidge(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
  const Labelling& labelling, const RightAlready& right)
{
  return RidgeFinder(mesh, connectivity, faces, labelling, right).Find();
}
}
