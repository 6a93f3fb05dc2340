// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file OwnFrame.h
/// The frame of reference that a mesh brings along: wherever the mesh is, however it is turned and
/// in whatever unit, its coordinates there are the same.

#ifndef arris_Robust_OwnFrame_h
#define arris_Robust_OwnFrame_h

#include "Core/Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// The origin is the mean of the vertices, the axes are their principal ones, each with the half
/// ahead that reaches farther (by the third moment), and the unit is the geometric mean of the
/// edges' lengths, on which a few huge triangles have no say.
///
/// A motion rounds coordinates, and where a decision hangs on that the mesh would come out
/// otherwise. So coordinates are taken on a grid far coarser than this rounding, and still far
/// finer than anything that is measured on a mesh.
class ARRISFILTERS_EXPORT OwnFrame
{
public:
  OwnFrame(const Mesh& mesh, const Connectivity& connectivity);

  /// The length of 1, in the mesh's unit.
  double Unit() const { return this->UnitLength; }

  /// Whether left is right there.
  bool Mirrors() const { return this->Axes.determinant() < 0.0; }

  /// On the grid.
  Vec3 Into(const Vec3& point) const;
  Vec3 Back(const Vec3& point) const;

private:
  Vec3 Origin = Vec3::Zero();
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity(); ///< rows
  double UnitLength = 1.0;
  double Grid = 0.0; ///< 0: none
};
}

#endif
