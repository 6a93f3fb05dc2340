// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file OwnMesh.h
/// A mesh in a frame and an order of its own, in which the robust method sees it: so what comes out
/// does not depend on where the mesh is, how it is turned or how it is stored.

#ifndef arris_Robust_OwnMesh_h
#define arris_Robust_OwnMesh_h

#include "OwnFrame.h"
#include "OwnOrder.h"
#include "Robust.h"

namespace arris
{
class ARRISFILTERS_EXPORT OwnMesh
{
public:
  OwnMesh(const Mesh& mesh, const Connectivity& connectivity);

  Mesh TheMesh;
  Connectivity TheConnectivity;

  RobustParameters Into(RobustParameters parameters) const;

  /// A result for the mesh as it was given. Vertices that have not moved keep every bit.
  RobustResult Back(RobustResult result) const;

private:
  std::vector<Vec3> PointsBack(const std::vector<Vec3>& points) const;
  std::vector<Triangle> TrianglesBack(const std::vector<Triangle>& triangles) const;

  const Mesh& Given;
  OwnFrame Frame;
  OwnOrder Order;
};
}

#endif
