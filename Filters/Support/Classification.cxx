// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Classification.h"

#include "Core/Geometry.h"
#include "Core/StopWatch.h"
#include "Support/Arrays.h"

#include <vtkPolyData.h>

namespace arris
{
bool Classification::Knows(vtkPolyData* input, const AssemblyParameters& assembled,
  const ClassificationParameters& parameters) const
{
  return input == this->Input && input->GetMTime() == this->InputTime &&
    assembled.PatchArray == this->Assembled.PatchArray &&
    assembled.MergeTolerance == this->Assembled.MergeTolerance &&
    parameters.WindowRadius == this->WindowRadius && parameters.Search == this->Search;
}

bool Classification::Update(vtkPolyData* input, const Surface& surface,
  const ClassificationParameters& parameters, const Monitor& monitor, vtkPolyData* output)
{
  double seconds = 0.0;
  if (!this->Knows(input, surface.AssembledBy, parameters))
  {
    const StopWatch watch;
    this->Input = nullptr;
    const Mesh& mesh = surface.Triangulation;
    this->DifferenceOfVertex =
      NormalDifferences(mesh, surface.Adjacency, UnitNormals(mesh, surface.AverageEdgeLength),
        parameters.WindowRadius, parameters.Search, monitor);
    if (this->DifferenceOfVertex.size() != mesh.Points.size())
    {
      return false;
    }
    this->Input = input;
    this->InputTime = input->GetMTime();
    this->Assembled = surface.AssembledBy;
    this->WindowRadius = parameters.WindowRadius;
    this->Search = parameters.Search;
    seconds = watch.Seconds();
  }
  this->SharpVertices = SharpRegion(this->DifferenceOfVertex, parameters.SharpAngle);
  AddClassification(output, this->DifferenceOfVertex, parameters.WindowRadius, this->SharpVertices);
  AddFieldValue(output, array::Lambda, parameters.WindowRadius);
  AddFieldValue(output, array::SharpAngle, parameters.SharpAngle);
  AddFieldValue(output, array::AverageEdgeLength, surface.AverageEdgeLength);
  AddFieldValue(output, array::ClassificationSeconds, seconds);
  return monitor.Report(1.0);
}
}
