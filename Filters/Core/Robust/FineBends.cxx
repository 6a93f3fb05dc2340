// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FineBends.h"

#include "Core/Geometry.h"

namespace arris
{
double BendTriangleSize(const Mesh& mesh, const Flags& region)
{
  struct Areas
  {
    double Sum = 0.0;
    Index Count = 0;
    double Mean() const { return this->Sum / static_cast<double>(this->Count); }
  };
  Areas of[4]; // by how many of the triangle's vertices are in the region
  for (const Triangle& c : mesh.Triangles)
  {
    Areas& areas = of[region[c[0]] + region[c[1]] + region[c[2]]];
    areas.Sum +=
      Corners(mesh.Points[c[0]], mesh.Points[c[1]], mesh.Points[c[2]]).AreaVector().norm();
    ++areas.Count;
  }
  const Areas& faces = of[0];
  const Areas& bends = of[3];
  return bends.Count > 0 && faces.Sum > 0.0 ? bends.Mean() / faces.Mean() : 1.0;
}
}
