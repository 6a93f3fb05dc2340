// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Meshes.h
/// Small meshes whose geometry is known in closed form. All are wound so that normals look
/// outwards, or up the z axis.

#ifndef arris_testing_Meshes_h
#define arris_testing_Meshes_h

#include "Core/Geometry.h"
#include "Core/Mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace arris
{
namespace testing
{
/// Adds the quadrangle a, b, c, d as the triangles a, b, c and a, c, d.
inline void AddQuad(Mesh& mesh, Index a, Index b, Index c, Index d)
{
  mesh.Triangles.push_back({ a, b, c });
  mesh.Triangles.push_back({ a, c, d });
}

/// Moves a profile `steps` times by `step`. Vertex j * profile.size() + i is profile point i after
/// j steps. A closed profile joins its last point to its first. Normals look along
/// (direction of the profile) x step.
inline Mesh Extrude(
  const std::vector<Vec3>& profile, Index steps, const Vec3& step, bool closed = false)
{
  Mesh mesh;
  const Index width = static_cast<Index>(profile.size());
  for (Index j = 0; j <= steps; ++j)
  {
    for (const Vec3& point : profile)
    {
      mesh.Points.emplace_back(point + static_cast<double>(j) * step);
    }
  }
  for (Index j = 0; j < steps; ++j)
  {
    for (Index i = 0; i < (closed ? width : width - 1); ++i)
    {
      const Index a = j * width + i;
      const Index b = j * width + (i + 1) % width;
      AddQuad(mesh, a, b, b + width, a + width);
    }
  }
  return mesh;
}

/// `columns` x `rows` unit squares in the plane z = 0, all cut along the same diagonal, from
/// (0, 0) to (1, 1). Vertex j * (columns + 1) + i is at (i, j, 0).
inline Mesh FlatGrid(Index columns, Index rows)
{
  std::vector<Vec3> profile;
  for (Index i = 0; i <= columns; ++i)
  {
    profile.emplace_back(i, 0.0, 0.0);
  }
  return Extrude(profile, rows, Vec3(0.0, 1.0, 0.0));
}

/// The vertex in the middle of a flat grid of width x width squares.
constexpr Index MiddleOfGrid(Index width)
{
  return (width / 2) * (width + 1) + width / 2;
}

/// The profile in the plane y = 0 of two half planes that meet at the origin with `angle` (degrees)
/// between their normals: `width` points one unit apart on each, and the fold between them, at
/// index `width`. Positive angles fold down (a ridge), negative ones up (a valley).
inline std::vector<Vec3> FoldProfile(Index width, double angle)
{
  const double half = 0.5 * angle * Pi / 180.0;
  std::vector<Vec3> profile;
  for (Index i = -width; i <= width; ++i)
  {
    const double along = std::abs(static_cast<double>(i));
    profile.emplace_back(i * std::cos(half), 0.0, -along * std::sin(half));
  }
  return profile;
}

/// Two half planes as above, `rows` units long in y.
inline Mesh Fold(Index width, Index rows, double angle)
{
  return Extrude(FoldProfile(width, angle), rows, Vec3(0.0, 1.0, 0.0));
}

/// The same with the fold cut off: the column of vertices along it is sunk by `depth`.
inline Mesh ChamferedFold(Index width, Index rows, double angle, double depth)
{
  std::vector<Vec3> profile = FoldProfile(width, angle);
  profile[width].z() -= angle > 0.0 ? depth : -depth;
  return Extrude(profile, rows, Vec3(0.0, 1.0, 0.0));
}

/// The surface of the box (0, 0, 0) to (nx, ny, nz) in unit squares, each cut along the diagonal
/// that leads away from the nearest corner of its face: so the mesh looks alike at all corners.
inline Mesh Box(Index nx, Index ny, Index nz)
{
  Mesh mesh;
  const std::array<Index, 3> size = { nx, ny, nz };
  std::map<std::array<Index, 3>, Index> known;
  const auto vertex = [&](const std::array<Index, 3>& at)
  {
    const auto inserted = known.insert({ at, mesh.VertexCount() });
    if (inserted.second)
    {
      mesh.Points.emplace_back(at[0], at[1], at[2]);
    }
    return inserted.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const bool far : { false, true })
    {
      for (Index i = 0; i < size[u]; ++i)
      {
        for (Index j = 0; j < size[v]; ++j)
        {
          const auto at = [&](Index di, Index dj)
          {
            std::array<Index, 3> point{};
            point[axis] = far ? size[axis] : 0;
            point[u] = i + di;
            point[v] = j + dj;
            return vertex(point);
          };
          std::array<Index, 4> square = { at(0, 0), at(1, 0), at(1, 1), at(0, 1) };
          if ((2 * i < size[u]) != (2 * j < size[v]))
          {
            std::rotate(square.begin(), square.begin() + 1, square.end());
          }
          if (!far)
          {
            std::swap(square[1], square[3]);
          }
          AddQuad(mesh, square[0], square[1], square[2], square[3]);
        }
      }
    }
  }
  return mesh;
}

/// A cylinder along z, open at both ends: `segments` flat strips, `rows` rows of height `height`.
inline Mesh Tube(double radius, Index segments, Index rows, double height)
{
  std::vector<Vec3> profile;
  for (Index i = 0; i < segments; ++i)
  {
    const double angle = 2.0 * Pi * i / segments;
    profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return Extrude(profile, rows, Vec3(0.0, 0.0, height), true);
}

/// A box of n x n x n squares blown up to a sphere: all vertices on it, edges of similar length.
inline Mesh Sphere(double radius, Index n)
{
  Mesh mesh = Box(n, n, n);
  for (Vec3& point : mesh.Points)
  {
    point = radius * (point - Vec3::Constant(0.5 * n)).normalized();
  }
  return mesh;
}

/// A torus about z: `around` steps about the axis, `across` about the tube.
inline Mesh Torus(double ringRadius, double tubeRadius, Index around, Index across)
{
  Mesh mesh;
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const double u = 2.0 * Pi * i / around;
      const double v = 2.0 * Pi * j / across;
      const double out = ringRadius + tubeRadius * std::cos(v);
      mesh.Points.emplace_back(out * std::cos(u), out * std::sin(u), tubeRadius * std::sin(v));
    }
  }
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const Index nextI = (i + 1) % around;
      const Index nextJ = (j + 1) % across;
      AddQuad(mesh, i * across + j, nextI * across + j, nextI * across + nextJ, i * across + nextJ);
    }
  }
  return mesh;
}

/// `wings` triangles on the edge from vertex 0 to vertex 1, at equal angles about it: with three
/// and more a non-manifold edge.
inline Mesh Wings(Index wings)
{
  Mesh mesh;
  mesh.Points = { Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0) };
  for (Index i = 0; i < wings; ++i)
  {
    const double angle = 2.0 * Pi * i / wings;
    mesh.Points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
    mesh.Triangles.push_back({ 0, 1, i + 2 });
  }
  return mesh;
}

/// Puts a second mesh beside the first, sharing nothing; the number of its first vertex.
inline Index Append(Mesh& mesh, const Mesh& other)
{
  const Index first = mesh.VertexCount();
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (const Triangle& t : other.Triangles)
  {
    mesh.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
  return first;
}

/// The length of the longest edge.
inline double LongestEdge(const Mesh& mesh)
{
  double longest = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest, (mesh.Points[t[k]] - mesh.Points[t[Next(k)]]).norm());
    }
  }
  return longest;
}

/// The triangles within a distance of a vertex, ascending, by looking at every one.
inline std::vector<Index> TrianglesWithin(const Mesh& mesh, Index vertex, double radius)
{
  std::vector<Index> within;
  for (Index t = 0; t < mesh.TriangleCount(); ++t)
  {
    if (SquaredDistance(mesh.Points[vertex], Corners(mesh, t)) <= radius * radius)
    {
      within.push_back(t);
    }
  }
  return within;
}

inline std::vector<Index> Sorted(std::vector<Index> indices)
{
  std::sort(indices.begin(), indices.end());
  return indices;
}

inline std::vector<Index> ToVector(IndexSpan span)
{
  return { span.begin(), span.end() };
}
}
}

#endif
