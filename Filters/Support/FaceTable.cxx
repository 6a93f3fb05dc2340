// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureOutputs.h"

#include "Arrays.h"
#include "Core/Geometry.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

namespace arris
{
namespace
{
/// Adds a column whose value in row i is valueAt(i), a number or a vector.
template <typename ArrayType, typename ValueAt>
void AddColumn(vtkTable* table, const char* name, std::size_t rows, ValueAt&& valueAt)
{
  vtkNew<ArrayType> column;
  column->SetName(name);
  for (std::size_t i = 0; i < rows; ++i)
  {
    column->InsertNextValue(valueAt(i));
  }
  table->AddColumn(column);
}

template <typename VectorAt>
void AddVectorColumn(vtkTable* table, const char* name, std::size_t rows, VectorAt&& vectorAt)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  column->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < rows; ++i)
  {
    const Vec3 vector = vectorAt(i);
    column->InsertNextTuple(vector.data());
  }
  table->AddColumn(column);
}

void AddShapes(vtkTable* table, const std::vector<FaceFit>& fits)
{
  const std::size_t rows = fits.size();
  AddColumn<vtkStringArray>(
    table, array::FacePrimitive, rows, [&](std::size_t i) { return NameOf(fits[i].Shape.Kind); });
  AddVectorColumn(
    table, array::FacePoint, rows, [&](std::size_t i) { return fits[i].Shape.Point; });
  AddVectorColumn(table, array::FaceAxis, rows, [&](std::size_t i) { return fits[i].Shape.Axis; });
  AddColumn<vtkDoubleArray>(
    table, array::FaceRadius, rows, [&](std::size_t i) { return fits[i].Shape.Radius; });
  AddColumn<vtkDoubleArray>(
    table, array::FaceMinorRadius, rows, [&](std::size_t i) { return fits[i].Shape.MinorRadius; });
  AddColumn<vtkDoubleArray>(table, array::FaceHalfAngle, rows,
    [&](std::size_t i) { return fits[i].Shape.HalfAngle * 180.0 / Pi; });
  AddColumn<vtkDoubleArray>(
    table, array::FaceResidual, rows, [&](std::size_t i) { return fits[i].Residual; });
}
}

void FillFaceTable(
  vtkTable* table, const std::vector<SurfaceMeasures>& measures, const std::vector<FaceFit>& fits)
{
  const std::size_t rows = measures.size();
  AddColumn<vtkIntArray>(
    table, array::SurfaceId, rows, [](std::size_t i) { return static_cast<int>(i); });
  AddColumn<vtkDoubleArray>(
    table, array::FaceArea, rows, [&](std::size_t i) { return measures[i].Area; });
  AddColumn<vtkIntArray>(
    table, array::FaceTriangles, rows, [&](std::size_t i) { return measures[i].Triangles; });
  AddColumn<vtkIntArray>(table, array::FaceBoundaryLoops, rows,
    [&](std::size_t i) { return measures[i].BoundaryLoops; });
  if (!fits.empty())
  {
    AddShapes(table, fits);
  }
}
}
