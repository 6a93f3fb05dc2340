// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RightAlready.h"

#include "Core/Geometry.h"
#include "Core/Parallel.h"
#include "MeetSheets.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
/// The corners of a triangle that lies on a face are no farther from it, in local scales: the error
/// of carrying a curved face on. What sampling cuts off is farther away.
constexpr double OnFace = 0.01;

/// How far a facet of a curved face may be turned against it, in degrees.
constexpr double AlongFace = 10.0;

/// The face of `vertex` that the triangle lies on; NoIndex if none.
Index FaceUnder(const Mesh& mesh, const Faces& faces, const std::vector<Side>& sides, double scale,
  Index triangle)
{
  const double along = std::cos(AlongFace * Pi / 180.0);
  Index face = NoIndex;
  double nearest = OnFace * scale;
  for (const Side& side : sides)
  {
    double farthest = 0.0;
    for (Index corner : mesh.Triangles[triangle])
    {
      farthest = std::max(farthest, std::abs(side.Surface.Distance(mesh.Points[corner])));
    }
    const Vec3& normal = faces.Normals[triangle];
    if (farthest < nearest &&
      (normal.isZero(0.0) ||
        normal.dot(side.Surface.Normal(Corners(mesh, triangle).Centroid())) >= along))
    {
      nearest = farthest;
      face = side.Patch;
    }
  }
  return face;
}

class RightFinder
{
public:
  RightFinder(const Mesh& mesh, const Connectivity& connectivity, const Faces& faces,
    const std::vector<double>& scales, const Labelling& labelling)
    : TheMesh(mesh)
    , TheConnectivity(connectivity)
    , TheFaces(faces)
    , Scales(scales)
    , TheLabelling(labelling)
  {
  }

  RightAlready Find()
  {
    this->Right.Labels.assign(this->TheMesh.Triangles.size(), NoIndex);
    ParallelFor(this->TheMesh.TriangleCount(),
      [this](Index begin, Index end)
      {
        for (Index t = begin; t < end; ++t)
        {
          this->Right.Labels[t] = this->LabelOf(t);
        }
      });
    this->Right.OnRidge.assign(this->TheMesh.Points.size(), 0);
    ParallelFor(this->TheMesh.VertexCount(),
      [this](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          this->Right.OnRidge[v] = this->IsOnRidge(v) ? 1 : 0;
        }
      });
    return std::move(this->Right);
  }

private:
  Index LabelOf(Index triangle) const
  {
    for (Index v : this->TheMesh.Triangles[triangle])
    {
      if (this->TheLabelling.SidesOf[v] != NoIndex)
      {
        return FaceUnder(this->TheMesh, this->TheFaces,
          this->TheLabelling.Sides[this->TheLabelling.SidesOf[v]], this->Scales[v], triangle);
      }
    }
    return NoIndex;
  }

  bool IsOnRidge(Index vertex) const
  {
    if (this->TheLabelling.SidesOf[vertex] == NoIndex)
    {
      return false;
    }
    const double like = std::cos(LeastCrossingAngle * Pi / 180.0);
    const Vec3& x = this->TheMesh.Points[vertex];
    const Sheet* first = nullptr;
    bool several = false;
    for (Index t : this->TheConnectivity.TrianglesOfVertex[vertex])
    {
      const Sheet* sheet =
        this->TheLabelling.SheetAt(this->TheConnectivity, vertex, this->Right.Labels[t]);
      if (this->Right.Labels[t] == NoIndex || sheet == nullptr)
      {
        return false;
      }
      first = first != nullptr ? first : sheet;
      several = several || first->Normal(x).dot(sheet->Normal(x)) < like;
    }
    return several;
  }

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const Faces& TheFaces;
  const std::vector<double>& Scales;
  const Labelling& TheLabelling;
  RightAlready Right;
};
}

RightAlready FindRightAlready(const Mesh& mesh, const Connectivity& connectivity,
  const Faces& faces, const std::vector<double>& scales, const Labelling& labelling)
{
  return RightFinder(mesh, connectivity, faces, scales, labelling).Find();
}
}
