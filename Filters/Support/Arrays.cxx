// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Arrays.h"

#include "Core/Geometry.h"
#include "Core/Parallel.h"
#include "Core/Thinning.h"
#include "Support/Surface.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace arris
{
namespace
{
/// Adds a point array whose value at v is valueAt(v).
template <typename ArrayType, typename ValueAt>
void AddPointArray(vtkPolyData* output, const char* name, ValueAt&& valueAt)
{
  const vtkIdType count = output->GetNumberOfPoints();
  vtkNew<ArrayType> values;
  values->SetName(name);
  values->SetNumberOfValues(count);
  ParallelFor(static_cast<Index>(count),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        values->SetValue(v, valueAt(v));
      }
    });
  output->GetPointData()->AddArray(values);
}

/// radiusAt(v) is the window radius of a point.
template <typename RadiusAt>
void AddClassificationBy(vtkPolyData* output, const std::vector<double>& normalDifferences,
  RadiusAt&& radiusAt, const Flags& sharpRegion)
{
  AddPointArray<vtkDoubleArray>(output, array::Ussod,
    [&](Index v)
    {
      const double radius = radiusAt(v);
      return radius > 0.0 ? normalDifferences[v] / radius : 0.0;
    });
  AddPointArray<vtkDoubleArray>(output, array::NormalDeviation,
    [&](Index v) { return AngleOfDifference(normalDifferences[v]); });
  AddPointArray<vtkUnsignedCharArray>(
    output, array::SharpRegion, [&](Index v) { return sharpRegion[v]; });
}
}

std::string ReadPointValues(
  vtkDataArray* array, const char* name, vtkPolyData* input, std::vector<double>& values)
{
  const vtkIdType count = input->GetNumberOfPoints();
  if (array == nullptr)
  {
    return std::string("the input has no point array ") + name;
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count)
  {
    return std::string("the point array ") + name + " must hold one number a point";
  }
  values.resize(count);
  for (vtkIdType v = 0; v < count; ++v)
  {
    values[v] = array->GetComponent(v, 0);
    if (!std::isfinite(values[v]))
    {
      return std::string("the point array ") + name + " is not finite at point " +
        std::to_string(v);
    }
  }
  return {};
}

std::string ReadThinningRounds(vtkDataArray* array, vtkPolyData* input, std::vector<int>& rounds)
{
  std::vector<double> values;
  std::string problem = ReadPointValues(array, array::ThinningRound, input, values);
  if (!problem.empty())
  {
    return problem;
  }
  rounds.resize(values.size());
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    // No thinning takes more rounds than there are vertices.
    const bool isRound = values[v] == NeverSharp ||
      (values[v] >= 1.0 && values[v] <= static_cast<double>(values.size()) + 1.0 &&
        values[v] == std::floor(values[v]));
    if (!isRound)
    {
      return std::string("the point array ") + array::ThinningRound + " must hold -1, or rounds " +
        "from 1 up to the number of points; at point " + std::to_string(v) + " it is " +
        std::to_string(values[v]);
    }
    rounds[v] = static_cast<int>(values[v]);
  }
  return {};
}

Flags NonZero(const std::vector<double>& values)
{
  Flags flags(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    flags[i] = values[i] != 0.0 ? 1 : 0;
  }
  return flags;
}

void AddClassification(vtkPolyData* output, const std::vector<double>& normalDifferences,
  double windowRadius, const Flags& sharpRegion)
{
  AddClassificationBy(
    output, normalDifferences, [=](Index) { return windowRadius; }, sharpRegion);
}

void AddClassification(vtkPolyData* output, const std::vector<double>& normalDifferences,
  const std::vector<double>& windowRadii, const Flags& sharpRegion)
{
  AddClassificationBy(
    output, normalDifferences, [&](Index v) { return windowRadii[v]; }, sharpRegion);
}

void AddThinning(
  vtkPolyData* output, const std::vector<int>& rounds, const std::vector<SkeletonRole>& roles)
{
  AddPointArray<vtkIntArray>(output, array::ThinningRound, [&](Index v) { return rounds[v]; });
  AddPointArray<vtkUnsignedCharArray>(
    output, array::SkeletonRole, [&](Index v) { return static_cast<unsigned char>(roles[v]); });
}

void AddAccount(vtkPolyData* output, const std::vector<double>& windowRadii,
  const std::vector<double>& edgeAngles, const std::vector<Outcome>& outcomes)
{
  AddPointArray<vtkDoubleArray>(output, array::Window, [&](Index v) { return windowRadii[v]; });
  AddPointArray<vtkDoubleArray>(output, array::EdgeAngle, [&](Index v) { return edgeAngles[v]; });
  AddPointArray<vtkUnsignedCharArray>(
    output, array::Outcome, [&](Index v) { return static_cast<unsigned char>(outcomes[v]); });
}

void AddSurfaceIds(vtkPolyData* output, const std::vector<Index>& ids, const Surface& surface)
{
  vtkNew<vtkIntArray> surfaceIds;
  surfaceIds->SetName(array::SurfaceId);
  surfaceIds->SetNumberOfValues(output->GetNumberOfCells());
  surfaceIds->FillValue(NoIndex);
  ParallelFor(static_cast<Index>(ids.size()),
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        surfaceIds->SetValue(surface.CellOf(t), ids[t]);
      }
    });
  output->GetCellData()->AddArray(surfaceIds);
}

void AddDisplacement(vtkPolyData* output, vtkPoints* before)
{
  const vtkIdType count = output->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> displacement;
  displacement->SetName(array::Displacement);
  displacement->SetNumberOfComponents(3);
  displacement->SetNumberOfTuples(count);
  ParallelFor(static_cast<Index>(count),
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        Vec3 now;
        Vec3 then;
        output->GetPoints()->GetPoint(v, now.data());
        before->GetPoint(v, then.data());
        const Vec3 step = now - then;
        displacement->SetTypedTuple(v, step.data());
      }
    });
  output->GetPointData()->AddArray(displacement);
}

void AddFieldValue(vtkPolyData* output, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

double FieldValue(vtkPolyData* input, const char* name, double otherwise)
{
  vtkDataArray* array = input->GetFieldData()->GetArray(name);
  return array != nullptr && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : otherwise;
}
}
