// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PickedPoints.h"

#include "Support/Selections.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace arris
{
namespace
{
std::string Number(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string Name(const double position[3])
{
  return "(" + Number(position[0]) + ", " + Number(position[1]) + ", " + Number(position[2]) + ")";
}

std::string Describe(double deviation)
{
  return Number(deviation) + " degrees";
}
}

std::string AddSelection(vtkSelection* selection, vtkPolyData* input, PickedPoints& picked)
{
  if (selection == nullptr || selection->GetNumberOfNodes() == 0)
  {
    return {};
  }
  SelectedElements selected;
  const std::string problem = EvaluateSelection(selection, input, selected);
  if (!problem.empty())
  {
    return "the selection of picked points: " + problem;
  }
  vtkNew<vtkIdList> points;
  for (const vtkIdType id : selected.Ids)
  {
    points->SetNumberOfIds(1);
    points->SetId(0, id);
    if (selected.AreCells)
    {
      input->GetCellPoints(id, points);
    }
    picked.Vertices.emplace_back(points->begin(), points->end());
    picked.Names.push_back((selected.AreCells ? "cell " : "point ") + std::to_string(id));
  }
  return {};
}

std::string AddPositions(vtkPoints* positions, const Surface& surface, PickedPoints& picked)
{
  const Mesh& mesh = surface.Triangulation;
  for (vtkIdType i = 0; positions != nullptr && i < positions->GetNumberOfPoints(); ++i)
  {
    const Vec3 position(positions->GetPoint(i));
    Index nearest = NoIndex;
    double least = std::numeric_limits<double>::infinity();
    for (Index v = 0; v < mesh.VertexCount(); ++v)
    {
      const double distance = (mesh.Points[v] - position).squaredNorm();
      if (distance < least && !surface.Adjacency.TrianglesOfVertex[v].empty())
      {
        nearest = v;
        least = distance;
      }
    }
    if (nearest == NoIndex || std::sqrt(least) > LargestPickDistance * surface.AverageEdgeLength)
    {
      return "the picked point " + Name(position.data()) + " is " + Number(std::sqrt(least)) +
        " away from the mesh, more than " + Number(LargestPickDistance) + " average edge lengths";
    }
    picked.Vertices.push_back({ nearest });
    picked.Names.push_back(Name(position.data()));
  }
  return {};
}

std::string FollowPickedPoints(const Surface& surface, const PickedPoints& sharp,
  const PickedPoints& smooth, ClassificationParameters& parameters)
{
  const FollowedPicks followed = FollowPicks(surface.Triangulation, surface.Adjacency,
    surface.AverageEdgeLength, { sharp.Vertices, smooth.Vertices }, parameters);
  switch (followed.Verdict)
  {
    case PickVerdict::Contradictory:
      return "the picked points contradict each other: " + smooth.Names[followed.Smooth] +
        ", picked as smooth (" + Describe(followed.SmoothDeviation) + "), is not smoother than " +
        sharp.Names[followed.Sharp] + ", picked as sharp (" + Describe(followed.SharpDeviation) +
        ")";
    case PickVerdict::NotSharp:
      return sharp.Names[followed.Sharp] +
        " was picked as sharp, but the surface around it is flat";
    case PickVerdict::Followed:
      break;
  }
  parameters = followed.Parameters;
  return {};
}
}
