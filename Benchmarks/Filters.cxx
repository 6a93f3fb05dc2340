// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

// Whole filters, Arris' and those of VTK that stand next to them in pipelines, on the same meshes.
// Arguments: kind of mesh, thousands of triangles, threads.

#include "Memory.h"
#include "Meshes.h"

#include "vtkSharpEdgeExtractor.h"
#include "vtkSharpEdgePreview.h"
#include "vtkSharpEdgeReconstruction.h"
#include "vtkUSSODFilter.h"

#include <benchmark/benchmark.h>

#include <vtkFeatureEdges.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyDataNormals.h>
#include <vtkSMPTools.h>
#include <vtkWindowedSincPolyDataFilter.h>

using namespace arris::benchmarks;

namespace
{
/// Times `prepare(filter)` and its update; each time a new filter, as Arris' keep what they know.
template <typename Filter, typename Prepare>
void Time(benchmark::State& state, vtkPolyData* mesh, Prepare&& prepare)
{
  vtkSMPTools::Initialize(static_cast<int>(state.range(2)));
  const auto execute = [&]
  {
    vtkNew<Filter> filter;
    prepare(filter.Get());
    filter->Update();
  };
  for (auto _ : state)
  {
    execute();
  }
  const auto triangles = static_cast<double>(mesh->GetNumberOfPolys());
  state.counters["triangles"] = triangles;
  // The kilobytes are VTK's, which rounds down.
  state.counters["peak"] =
    PeakBytes(execute) / (1024.0 * static_cast<double>(mesh->GetActualMemorySize()));
}

vtkPolyData* MeshFor(const benchmark::State& state)
{
  return MeshOf(static_cast<MeshKind>(state.range(0)), static_cast<int>(state.range(1)));
}

void Smoothing(benchmark::State& state)
{
  vtkPolyData* mesh = MeshFor(state);
  Time<vtkWindowedSincPolyDataFilter>(state, mesh,
    [&](vtkWindowedSincPolyDataFilter* filter)
    {
      filter->SetInputData(mesh);
      filter->SetNumberOfIterations(20);
    });
}

void Normals(benchmark::State& state)
{
  vtkPolyData* mesh = MeshFor(state);
  Time<vtkPolyDataNormals>(
    state, mesh, [&](vtkPolyDataNormals* filter) { filter->SetInputData(mesh); });
}

void Contouring(benchmark::State& state)
{
  const auto volume = Volume(static_cast<int>(state.range(1)));
  Time<vtkFlyingEdges3D>(state, MeshFor(state),
    [&](vtkFlyingEdges3D* filter)
    {
      filter->SetInputData(volume);
      filter->SetValue(0, 0.0);
      filter->ComputeNormalsOff();
      filter->ComputeScalarsOff();
    });
}

template <typename Filter>
void Plainly(benchmark::State& state)
{
  vtkPolyData* mesh = MeshFor(state);
  Time<Filter>(state, mesh, [&](Filter* filter) { filter->SetInputData(mesh); });
}

template <int Method>
void Recovery(benchmark::State& state)
{
  vtkPolyData* mesh = MeshFor(state);
  Time<vtkSharpEdgeReconstruction>(state, mesh,
    [&](vtkSharpEdgeReconstruction* filter)
    {
      filter->SetInputData(mesh);
      filter->SetMethod(Method);
    });
}

template <typename Filter>
void EdgesOfRecovered(benchmark::State& state)
{
  vtkPolyData* mesh = RecoveredContour(static_cast<int>(state.range(1)));
  Time<Filter>(state, mesh, [&](Filter* filter) { filter->SetInputData(mesh); });
}

void OnContours(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgsProduct({ { static_cast<int>(MeshKind::Contour) }, { 100, 1000 }, { 1, 2 } });
}

void OnAllMeshes(benchmark::internal::Benchmark* benchmark)
{
  OnContours(benchmark);
  benchmark->ArgsProduct({ { static_cast<int>(MeshKind::Contour) }, { 10000 }, { 1, 2 } });
  benchmark->ArgsProduct({ { static_cast<int>(MeshKind::Irregular) }, { 100, 500 }, { 1, 2 } });
  benchmark->ArgsProduct({ { static_cast<int>(MeshKind::Shuffled) }, { 1000 }, { 1, 2 } });
}

#define ARRIS_BENCHMARK(name, function, meshes) \
  BENCHMARK(function)->Name(name)->Apply(meshes)->UseRealTime()->Unit(benchmark::kMillisecond)

ARRIS_BENCHMARK("vtkWindowedSincPolyDataFilter", Smoothing, OnAllMeshes);
ARRIS_BENCHMARK("vtkPolyDataNormals", Normals, OnAllMeshes);
ARRIS_BENCHMARK("vtkFlyingEdges3D", Contouring, OnContours);
ARRIS_BENCHMARK("vtkUSSODFilter", Plainly<vtkUSSODFilter>, OnAllMeshes);
ARRIS_BENCHMARK("vtkSharpEdgePreview", Plainly<vtkSharpEdgePreview>, OnAllMeshes);
ARRIS_BENCHMARK(
  "vtkSharpEdgeReconstruction, paper", Recovery<vtkSharpEdgeReconstruction::PAPER>, OnAllMeshes);
ARRIS_BENCHMARK(
  "vtkSharpEdgeReconstruction, robust", Recovery<vtkSharpEdgeReconstruction::ROBUST>, OnAllMeshes);
ARRIS_BENCHMARK("vtkFeatureEdges", EdgesOfRecovered<vtkFeatureEdges>, OnContours);
ARRIS_BENCHMARK("vtkSharpEdgeExtractor", EdgesOfRecovered<vtkSharpEdgeExtractor>, OnContours);
}
