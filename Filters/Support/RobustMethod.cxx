// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RobustMethod.h"

#include "Core/Robust/Turn.h"
#include "Support/Arrays.h"
#include "Support/AssembledSurface.h"
#include "Support/Parameters.h"
#include "Support/ReplaceTriangles.h"

#include <vtkPolyData.h>

namespace arris
{
bool RecoverByRobust(vtkPolyData* input, const Surface& surface, const RobustParameters& parameters,
  const Monitor& monitor, vtkPolyData* output)
{
  const Mesh& mesh = surface.Triangulation;
  RobustResult result = RecoverRobustly(mesh, surface.Adjacency, parameters, monitor);
  if (result.Points.size() != mesh.Points.size())
  {
    return false;
  }
  AddClassification(output, result.NormalDifferences, result.WindowRadii, result.Region);
  AddThinning(output, result.Rounds, result.Roles);
  AddAccount(output, result.WindowRadii, result.Jumps, result.Outcomes);
  AddFieldValue(output, array::Lambda,
    WindowRadius(parameters.WindowRadius, TurnWindow, surface.AverageEdgeLength));
  AddFieldValue(output, array::SharpAngle, result.SharpAngle);
  AddFieldValue(output, array::Roughness, result.Rough.Degree);
  AddFieldValue(output, array::Rounding, result.Rounding);
  AddFieldValue(output, array::BendTriangleSize, result.BendTriangleSize);
  AddFieldValue(output, array::BendsAreMeant, result.BendsAreMeant ? 1.0 : 0.0);
  AddFieldValue(output, array::EdgeFlips, result.EdgeFlips);
  AddFieldValue(output, array::AverageEdgeLength, surface.AverageEdgeLength);
  AddFieldValue(output, array::ClassificationSeconds, result.ClassificationSeconds);
  AddFieldValue(output, array::ThinningSeconds, result.ThinningSeconds);
  AddFieldValue(output, array::SharpeningSeconds, result.SharpeningSeconds);
  ShareAmongCommon(surface, output);
  ShareAmongCommon(surface, result.Points);
  ReplacePoints(output, result.Points);
  ReplaceTriangles(output, surface, result.Triangles);
  AddDisplacement(output, input->GetPoints());
  return true;
}

bool IsRough(vtkPolyData* recovered)
{
  return FieldValue(recovered, array::Roughness, 0.0) > 0.0;
}

bool AreBendsMeant(vtkPolyData* recovered)
{
  return FieldValue(recovered, array::BendsAreMeant, 0.0) > 0.0;
}
}
