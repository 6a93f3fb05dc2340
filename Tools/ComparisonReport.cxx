// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ComparisonReport.h"

#include <algorithm>
#include <cstdio>

namespace arris
{
namespace
{
/// The larger of both directions.
SurfaceDistance Larger(const SurfaceDistance& a, const SurfaceDistance& b)
{
  SurfaceDistance larger;
  larger.Max = std::max(a.Max, b.Max);
  larger.Mean = std::max(a.Mean, b.Mean);
  larger.Rms = std::max(a.Rms, b.Rms);
  larger.Samples = a.Samples + b.Samples;
  return larger;
}

Session::Json ToJson(const SurfaceDistance& distance, double diagonal)
{
  const double percent = 100.0 / diagonal;
  Session::Json json;
  json["max"] = distance.Max;
  json["mean"] = distance.Mean;
  json["rms"] = distance.Rms;
  json["max_percent"] = percent * distance.Max;
  json["mean_percent"] = percent * distance.Mean;
  json["rms_percent"] = percent * distance.Rms;
  json["samples"] = distance.Samples;
  return json;
}

std::string Row(const char* name, const SurfaceDistance& distance, double diagonal)
{
  const double percent = 100.0 / diagonal;
  char text[160];
  std::snprintf(text, sizeof(text), "%-18s %11.4g %11.4g %11.4g   %9.5f %9.5f %9.5f", name,
    distance.Max, distance.Mean, distance.Rms, percent * distance.Max, percent * distance.Mean,
    percent * distance.Rms);
  return text;
}
}

Session::Json ToJson(const Comparison& comparison)
{
  Session::Json json;
  json["diagonal"] = comparison.Diagonal;
  json["reference_to_mesh"] = ToJson(comparison.ReferenceToMesh, comparison.Diagonal);
  json["mesh_to_reference"] = ToJson(comparison.MeshToReference, comparison.Diagonal);
  json["larger"] =
    ToJson(Larger(comparison.ReferenceToMesh, comparison.MeshToReference), comparison.Diagonal);
  return json;
}

void SayComparison(const Session& session, const Comparison& comparison)
{
  const double diagonal = comparison.Diagonal;
  char head[160];
  std::snprintf(head, sizeof(head), "%-18s %11s %11s %11s   %9s %9s %9s", "distance", "max", "mean",
    "rms", "max %", "mean %", "rms %");
  session.Say(head);
  session.Say(Row("reference to mesh", comparison.ReferenceToMesh, diagonal));
  session.Say(Row("mesh to reference", comparison.MeshToReference, diagonal));
  session.Say(
    Row("the larger", Larger(comparison.ReferenceToMesh, comparison.MeshToReference), diagonal));
}
}
