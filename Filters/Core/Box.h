// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Box.h
/// Boxes along the axes.

#ifndef arris_Box_h
#define arris_Box_h

#include "Mesh.h"

#include <limits>

namespace arris
{
struct Box
{
  Vec3 Low = Vec3::Zero();
  Vec3 High = Vec3::Zero();

  Box() = default;

  /// Around nothing.
  static Box Empty()
  {
    Box box;
    box.Low = Vec3::Constant(std::numeric_limits<double>::max());
    box.High = -box.Low;
    return box;
  }

  /// Around a triangle.
  Box(const MeshView& mesh, Index t)
    : Low(mesh.Points[mesh.Triangles[t][0]])
    , High(this->Low)
  {
    for (int k = 1; k < 3; ++k)
    {
      this->Low = this->Low.cwiseMin(mesh.Points[mesh.Triangles[t][k]]);
      this->High = this->High.cwiseMax(mesh.Points[mesh.Triangles[t][k]]);
    }
  }
  double Width() const { return (this->High - this->Low).maxCoeff(); }
  bool Meets(const Box& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1] &&
      this->Low[2] <= other.High[2] && other.Low[2] <= this->High[2];
  }
  void Include(const Box& other)
  {
    this->Low = this->Low.cwiseMin(other.Low);
    this->High = this->High.cwiseMax(other.High);
  }
  void Include(const Vec3& point)
  {
    this->Low = this->Low.cwiseMin(point);
    this->High = this->High.cwiseMax(point);
  }
  void ClipTo(const Box& other)
  {
    this->Low = this->Low.cwiseMax(other.Low);
    this->High = this->High.cwiseMin(other.High);
  }
};
}

#endif
