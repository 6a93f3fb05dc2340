// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PaperMethod.h"

#include "Core/Sharpening.h"
#include "Core/Skeleton.h"
#include "Core/StopWatch.h"
#include "Core/Thinning.h"
#include "Support/Arrays.h"
#include "Support/AssembledSurface.h"

#include <vtkPolyData.h>

#include <utility>

namespace arris
{
namespace
{
// How far the progress has come after the first two stages, by their usual share of the time.
constexpr double Classified = 0.6;
constexpr double Thinned = 0.7;
}

bool RecoverByPaper(vtkPolyData* input, Surface surface, const ClassificationParameters& parameters,
  Classification& classification, const Monitor& monitor, vtkPolyData* output)
{
  Mesh& mesh = surface.Triangulation;
  const std::size_t count = mesh.Points.size();
  const Connectivity& connectivity = surface.Adjacency;
  if (!classification.Update(input, surface, parameters, monitor.Part(0.0, Classified), output))
  {
    return false;
  }

  const StopWatch thinning;
  const std::vector<int> rounds = ThinningRounds(mesh, connectivity, classification.Region(),
    classification.Differences(), monitor.Part(Classified, Thinned));
  if (rounds.size() != count)
  {
    return false;
  }
  const Skeleton skeleton = TraceSkeleton(mesh, connectivity, rounds);
  AddThinning(output, rounds, skeleton.Roles);
  AddFieldValue(output, array::ThinningSeconds, thinning.Seconds());

  const StopWatch sharpening;
  std::vector<Vec3> points = SharpenedPoints(std::move(mesh), connectivity, rounds, skeleton,
    parameters.WindowRadius, surface.AverageEdgeLength, monitor.Part(Thinned, 1.0));
  if (points.size() != count)
  {
    return false;
  }
  surface.Adjacency = Connectivity();
  ShareAmongCommon(surface, output);
  ShareAmongCommon(surface, points);
  ReplacePoints(output, points);
  AddDisplacement(output, input->GetPoints());
  AddFieldValue(output, array::SharpeningSeconds, sharpening.Seconds());
  return monitor.Report(1.0);
}
}
