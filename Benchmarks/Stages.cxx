// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

// The stages of the paper's method, each by itself. Arguments: kind of mesh, thousands of
// triangles, threads.

#include "Meshes.h"

#include "Core/Geometry.h"
#include "Core/Sharpening.h"
#include "Core/Skeleton.h"
#include "Core/Thinning.h"
#include "Core/Ussod.h"
#include "Support/Parameters.h"
#include "Support/Surface.h"

#include <benchmark/benchmark.h>

#include <vtkNew.h>
#include <vtkSMPTools.h>

using namespace arris;
using namespace arris::benchmarks;

namespace
{
/// What each stage leaves to the next.
struct Stages
{
  explicit Stages(benchmark::State& state)
    : Input(MeshOf(static_cast<MeshKind>(state.range(0)), static_cast<int>(state.range(1))))
  {
    vtkSMPTools::Initialize(static_cast<int>(state.range(2)));
    vtkNew<vtkPolyData> output;
    ReadSurface(this->Input, output, this->Data);
    this->Radius = DefaultWindowRatio * this->Data.AverageEdgeLength;
  }

  const Mesh& TheMesh() const { return this->Data.Triangulation; }

  std::vector<Vec3> FindNormals() const
  {
    return UnitNormals(this->TheMesh(), this->Data.AverageEdgeLength);
  }
  std::vector<double> Classify(const std::vector<Vec3>& normals, double ratio) const
  {
    return NormalDifferences(this->TheMesh(), this->Data.Adjacency, normals,
      ratio * this->Data.AverageEdgeLength, WindowSearch::Connected, Monitor());
  }
  std::vector<int> Thin(const std::vector<double>& differences) const
  {
    return ThinningRounds(this->TheMesh(), this->Data.Adjacency,
      SharpRegion(differences, DefaultSharpAngle), differences, Monitor());
  }

  vtkPolyData* Input;
  Surface Data;
  double Radius;
};

void Reading(benchmark::State& state)
{
  const Stages stages(state);
  for (auto _ : state)
  {
    vtkNew<vtkPolyData> output;
    Surface surface;
    ReadSurface(stages.Input, output, surface);
    benchmark::DoNotOptimize(surface.AverageEdgeLength);
  }
}

void Adjacency(benchmark::State& state)
{
  const Stages stages(state);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(Connectivity(stages.TheMesh()));
  }
}

void FaceNormals(benchmark::State& state)
{
  const Stages stages(state);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(stages.FindNormals());
  }
}

/// The last argument is the window in hundredths of the average edge length.
void Ussod(benchmark::State& state)
{
  const Stages stages(state);
  const std::vector<Vec3> normals = stages.FindNormals();
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(stages.Classify(normals, 0.01 * static_cast<double>(state.range(3))));
  }
}

void Thinning(benchmark::State& state)
{
  const Stages stages(state);
  const std::vector<double> differences = stages.Classify(stages.FindNormals(), DefaultWindowRatio);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(stages.Thin(differences));
  }
}

void Positions(benchmark::State& state)
{
  const Stages stages(state);
  const std::vector<int> rounds =
    stages.Thin(stages.Classify(stages.FindNormals(), DefaultWindowRatio));
  const Skeleton skeleton = TraceSkeleton(stages.TheMesh(), stages.Data.Adjacency, rounds);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(SharpenedPoints(stages.TheMesh(), stages.Data.Adjacency, rounds,
      skeleton, stages.Radius, stages.Data.AverageEdgeLength, Monitor()));
  }
}

void OnMeshes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgsProduct({ { 0 }, { 100, 1000 }, { 1, 2 } });
  benchmark->ArgsProduct({ { 1 }, { 100 }, { 1, 2 } });
  benchmark->ArgsProduct({ { 2 }, { 1000 }, { 1, 2 } });
}

#define ARRIS_STAGE(function) \
  BENCHMARK(function)->Apply(OnMeshes)->UseRealTime()->Unit(benchmark::kMillisecond)

ARRIS_STAGE(Reading);
ARRIS_STAGE(Adjacency);
ARRIS_STAGE(FaceNormals);
BENCHMARK(Ussod)
  ->ArgsProduct({ { 0 }, { 100, 1000 }, { 1, 2 }, { 50, 75, 100, 150 } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
ARRIS_STAGE(Thinning);
ARRIS_STAGE(Positions);
}
