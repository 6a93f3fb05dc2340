// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureFiles.h"

#include "AtomicFile.h"
#include "Csv.h"
#include "EMesh.h"
#include "Failure.h"
#include "InputFile.h"
#include "MeshFiles.h"

#include "Support/Arrays.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <initializer_list>

namespace arris
{
namespace
{
constexpr const char* CurveKinds[] = { "convex", "concave", "boundary", "non-manifold" };
constexpr const char* CornerKinds[] = { "convex", "concave", "saddle", "none" };

/// Adds the arrays of these names to a table; that of `kind` in words.
void AddColumns(vtkTable* table, vtkFieldData* from, std::initializer_list<const char*> names,
  const char* kind, const char* const words[])
{
  for (const char* name : names)
  {
    vtkDataArray* values = from->GetArray(name);
    if (std::string(name) != kind)
    {
      table->AddColumn(values);
      continue;
    }
    vtkNew<vtkStringArray> column;
    column->SetName(name);
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      column->InsertNextValue(words[static_cast<int>(values->GetComponent(i, 0))]);
    }
    table->AddColumn(column);
  }
}

bool IsCsv(const std::string& path)
{
  return Extension(path) == ".csv";
}

bool IsEMesh(const std::string& path)
{
  return Extension(path) == ".emesh"; // in lower case here, whatever the file's name has
}
}

void CheckCurvesOutput(const std::string& path)
{
  if (IsCsv(path) || IsEMesh(path))
  {
    CheckWritable(path);
    return;
  }
  CheckMeshOutput(path, Content::Curves);
}

void WriteCurves(const Features& found, const std::string& path, ProgressBar& progress)
{
  if (IsEMesh(path))
  {
    WriteEMesh(found.Curves, path);
    return;
  }
  if (!IsCsv(path))
  {
    WriteMesh(found.Curves, path, progress);
    return;
  }
  vtkNew<vtkTable> table;
  AddColumns(table, found.Curves->GetCellData(),
    { array::CurveId, array::CurveLength, array::DihedralAngle, array::MinimumDihedralAngle,
      array::MaximumDihedralAngle, array::CurveKind, array::Closed, array::LeftSurfaceId,
      array::RightSurfaceId },
    array::CurveKind, CurveKinds);
  WriteCsv(table, path);
}

void CheckCornersOutput(const std::string& path)
{
  if (IsCsv(path))
  {
    CheckWritable(path);
    return;
  }
  CheckMeshOutput(path, Content::Curves);
}

void WriteCorners(const Features& found, const std::string& path, ProgressBar& progress)
{
  if (!IsCsv(path))
  {
    WriteMesh(found.Corners, path, progress);
    return;
  }
  vtkNew<vtkTable> table;
  vtkDataArray* points = found.Corners->GetPoints()->GetData();
  const auto positions = vtk::TakeSmartPointer(points->NewInstance());
  positions->DeepCopy(points);
  positions->SetName("Point");
  table->AddColumn(positions);
  AddColumns(table, found.Corners->GetPointData(),
    { array::Valence, array::CornerKind, array::Tip, array::MeshPointId, array::CurveIds },
    array::CornerKind, CornerKinds);
  WriteCsv(table, path);
}

void CheckFacesOutput(const std::string& path)
{
  if (!IsCsv(path))
  {
    throw Failure(path, "is no table format that Arris writes", "use .csv");
  }
  CheckWritable(path);
}

void WriteFaces(const Features& found, const std::string& path)
{
  WriteCsv(found.Faces, path);
}
}
