// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFiles.h"

#include "ErrorCapture.h"
#include "Failure.h"
#include "InputFile.h"
#include "NrrdCheck.h"
#include "ProgressBar.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMetaImageReader.h>
#include <vtkNrrdReader.h>
#include <vtkPointData.h>
#include <vtkStructuredPointsReader.h>
#include <vtkXMLImageDataReader.h>

namespace arris
{
namespace
{
/// A reader for the file if it is what its extension says.
template <typename Reader>
vtkSmartPointer<vtkAlgorithm> OpenIfReadable(const std::string& path, const char* format)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Unreadable(path, std::string("it is no ") + format + " volume");
  }
  reader->SetFileName(path.c_str());
  return reader;
}

vtkSmartPointer<vtkAlgorithm> OpenLegacy(const std::string& path)
{
  const auto reader = vtkSmartPointer<vtkStructuredPointsReader>::New();
  reader->SetFileName(path.c_str());
  if (!reader->IsFileStructuredPoints())
  {
    throw Failure(path, "is not a legacy VTK file with structured points",
      "save the volume as STRUCTURED_POINTS, .vti, .mha or .nrrd");
  }
  return reader;
}

vtkSmartPointer<vtkAlgorithm> OpenByExtension(const std::string& path)
{
  const std::string extension = Extension(path);
  if (extension == ".vti")
  {
    return OpenIfReadable<vtkXMLImageDataReader>(path, "VTK XML");
  }
  if (extension == ".mha" || extension == ".mhd")
  {
    return OpenIfReadable<vtkMetaImageReader>(path, "MetaImage");
  }
  if (extension == ".nrrd")
  {
    const std::string problem = ProblemWithNrrd(path);
    if (!problem.empty())
    {
      throw Unreadable(path, problem);
    }
    return OpenIfReadable<vtkNrrdReader>(path, "NRRD");
  }
  if (extension == ".vtk")
  {
    return OpenLegacy(path);
  }
  throw Failure(path, "is not a volume format that Arris knows by its extension",
    "use .vti, .mha, .mhd, .nrrd or .vtk");
}
}

vtkSmartPointer<vtkImageData> ReadVolume(const std::string& path, ProgressBar& progress)
{
  CheckReadable(path);
  vtkSmartPointer<vtkImageData> volume;
  {
    const ErrorCapture capture; // some readers already speak when asked what they can read
    const auto reader = OpenByExtension(path);
    RunReader(path, reader, progress);
    volume = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  }
  if (volume == nullptr || volume->GetPointData()->GetScalars() == nullptr ||
    volume->GetPointData()->GetScalars()->GetNumberOfTuples() != volume->GetNumberOfPoints())
  {
    throw Failure(path, "holds no values at its samples", "give a volume of numbers");
  }
  int size[3];
  volume->GetDimensions(size);
  if (size[0] < 2 || size[1] < 2 || size[2] < 2)
  {
    throw Failure(path,
      "is not a volume: it has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
        " x " + std::to_string(size[2]) + " samples",
      "give at least two in each direction");
  }
  return volume;
}
}
