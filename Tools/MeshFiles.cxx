// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFiles.h"

#include "AtomicFile.h"
#include "CrashGuard.h"
#include "ErrorCapture.h"
#include "Failure.h"
#include "InputFile.h"
#include "ObjCheck.h"
#include "PlyCheck.h"
#include "ProgressBar.h"
#include "StlCheck.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOBJWriter.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLReader.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace arris
{
namespace
{
Failure UnknownFormat(const std::string& path)
{
  return Failure(path, "is not a mesh format that Arris knows by its extension",
    "use .vtp, .vtk, .ply, .stl or .obj");
}

template <typename Reader>
vtkSmartPointer<vtkAlgorithm> Open(const std::string& path)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

void ThrowIf(const std::string& path, const std::string& problem)
{
  if (!problem.empty())
  {
    throw Unreadable(path, problem);
  }
}

vtkSmartPointer<vtkAlgorithm> OpenPly(const std::string& path)
{
  ThrowIf(path, ProblemWithPly(path));
  const auto reader = vtkSmartPointer<vtkPLYReader>::New();
  reader->SetFileName(path.c_str());
  reader->SetDuplicatePointsForFaceTexture(false);
  return reader;
}

vtkSmartPointer<vtkAlgorithm> OpenLegacy(const std::string& path)
{
  const auto reader = vtkSmartPointer<vtkPolyDataReader>::New();
  reader->SetFileName(path.c_str());
  if (!reader->IsFilePolyData())
  {
    throw Failure(path, "is not a legacy VTK file with polygonal data", "save it as PolyData");
  }
  reader->ReadAllScalarsOn(); // else the first array of each kind only
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

vtkSmartPointer<vtkAlgorithm> OpenByExtension(const std::string& path)
{
  const std::string extension = Extension(path);
  if (extension == ".vtp")
  {
    return Open<vtkXMLPolyDataReader>(path);
  }
  if (extension == ".vtk")
  {
    return OpenLegacy(path);
  }
  if (extension == ".ply")
  {
    return OpenPly(path);
  }
  if (extension == ".stl")
  {
    ThrowIf(path, ProblemWithStl(path));
    return Open<vtkSTLReader>(path); // merges points that coincide exactly
  }
  if (extension == ".obj")
  {
    ThrowIf(path, CheckObj(path).Problem);
    return Open<vtkOBJReader>(path);
  }
  throw UnknownFormat(path);
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path, ProgressBar& progress)
{
  CheckReadable(path);
  const ErrorCapture capture; // some readers already speak when asked what they can read
  const auto reader = OpenByExtension(path);
  RunReader(path, reader, progress);
  return vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
}

/// Whether all cells name points that are there.
bool NamesItsPoints(vtkPolyData* mesh)
{
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    vtkDataArray* ids = cells->GetConnectivityArray();
    if (ids->GetNumberOfTuples() > 0 &&
      (ids->GetRange()[0] < 0.0 || ids->GetRange()[1] >= double(mesh->GetNumberOfPoints())))
    {
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkPolyData> MergeCoincidentPoints(vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> merge;
  merge->SetInputData(mesh);
  merge->ToleranceIsAbsoluteOn();
  merge->SetAbsoluteTolerance(0.0);
  merge->ConvertLinesToPointsOff();
  merge->ConvertPolysToLinesOff();
  merge->ConvertStripsToPolysOff();
  merge->Update();
  return merge->GetOutput();
}

template <typename Writer>
vtkSmartPointer<Writer> Create(vtkPolyData* mesh, const std::string& path)
{
  auto writer = vtkSmartPointer<Writer>::New();
  writer->SetFileName(path.c_str());
  writer->SetInputData(mesh);
  return writer;
}

vtkSmartPointer<vtkAlgorithm> CreateByExtension(
  vtkPolyData* mesh, const std::string& path, const std::string& extension)
{
  if (extension == ".vtp")
  {
    const auto writer = Create<vtkXMLPolyDataWriter>(mesh, path);
    writer->SetDataModeToBinary(); // inline: some readers get appended data wrong without a word
    return writer;
  }
  if (extension == ".vtk")
  {
    const auto writer = Create<vtkPolyDataWriter>(mesh, path);
    writer->SetFileTypeToBinary();
    return writer;
  }
  if (extension == ".ply")
  {
    return Create<vtkPLYWriter>(mesh, path);
  }
  if (extension == ".stl")
  {
    const auto writer = Create<vtkSTLWriter>(mesh, path);
    writer->SetFileTypeToBinary();
    return writer;
  }
  return Create<vtkOBJWriter>(mesh, path);
}

Failure Unwritable(const std::string& path, const std::string& cause)
{
  return Failure(path, "cannot be written: " + cause, "try another format or another place");
}

/// Runs a writer; its cause if it fails. Some crash where a file may not grow any more.
std::string RunWriter(vtkAlgorithm* writer, const std::string& path)
{
  const ErrorCapture capture;
  {
    const CrashGuard guard(
      std::string("arris: ") + Unwritable(path, "its writer has failed").what() + "\n");
    writer->Update();
  }
  const std::string cause = capture.FirstError();
  return cause.empty() && writer->GetErrorCode() != 0 ? "the writer failed" : cause;
}
}

vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& path, ProgressBar& progress)
{
  vtkSmartPointer<vtkPolyData> mesh = ReadPolyData(path, progress);
  if (mesh->GetNumberOfPolys() == 0 && mesh->GetNumberOfStrips() == 0)
  {
    throw Failure(path, "holds no triangles", "give a mesh of triangles or polygons");
  }
  if (!NamesItsPoints(mesh))
  {
    throw Failure(path, "has a cell that names a point that is not there", "repair the mesh first");
  }
  if (Extension(path) == ".obj" && CheckObj(path).VertexCount != mesh->GetNumberOfPoints())
  {
    return MergeCoincidentPoints(mesh);
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadCurves(const std::string& path, ProgressBar& progress)
{
  vtkSmartPointer<vtkPolyData> curves = ReadPolyData(path, progress);
  if (curves->GetNumberOfLines() == 0)
  {
    throw Failure(path, "holds no lines", "give a file with polylines");
  }
  return curves;
}

void CheckMeshOutput(const std::string& path, Content content)
{
  const std::string extension = Extension(path);
  const std::string withArrays[] = { ".vtp", ".vtk" };
  const std::string all[] = { ".vtp", ".vtk", ".ply", ".stl", ".obj" };
  if (std::find(std::begin(all), std::end(all), extension) == std::end(all))
  {
    throw UnknownFormat(path);
  }
  const bool holdsArrays =
    std::find(std::begin(withArrays), std::end(withArrays), extension) != std::end(withArrays);
  if (content == Content::MeshWithArrays && !holdsArrays)
  {
    throw Failure(path, extension + " files cannot hold arrays, and these are the result here",
      "use .vtp or .vtk");
  }
  if (content == Content::Curves && !holdsArrays && extension != ".obj")
  {
    throw Failure(
      path, extension + " files cannot hold curves", "use .vtp, .vtk, .obj, .csv or .eMesh");
  }
  CheckWritable(path);
}

void WriteMesh(vtkPolyData* mesh, const std::string& path, ProgressBar& progress)
{
  WriteAtomically(path,
    [&](const std::string& scratch)
    {
      const auto writer = CreateByExtension(mesh, scratch, Extension(path));
      progress.Follow("writing", writer);
      const std::string cause = RunWriter(writer, path);
      progress.Clear();
      if (!cause.empty())
      {
        throw Unwritable(path, cause);
      }
    });
}
}
