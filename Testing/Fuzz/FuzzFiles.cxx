// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// Any bytes under any extension that the program reads: a mesh or a volume that holds together, or
/// one line that says what is wrong. The first byte is the format: 'a' for the first one of Kinds.

#include "Failure.h"
#include "MeshFiles.h"
#include "ProgressBar.h"
#include "VolumeFiles.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <unistd.h>

namespace
{
struct Kind
{
  const char* Extension;
  bool IsVolume;
};
constexpr Kind Kinds[] = { { ".vtp", false }, { ".vtk", false }, { ".ply", false },
  { ".stl", false }, { ".obj", false }, { ".vti", true }, { ".mha", true }, { ".nrrd", true },
  { ".vtk", true } };

void Require(bool held, const char* promise)
{
  if (!held)
  {
    std::fprintf(stderr, "A promise was broken: %s\n", promise);
    std::abort();
  }
}

void ReadAny(const std::string& path, bool isVolume)
{
  arris::ProgressBar none(false);
  if (isVolume)
  {
    const vtkSmartPointer<vtkImageData> volume = arris::ReadVolume(path, none);
    vtkDataArray* values = volume->GetPointData()->GetScalars();
    Require(values->GetNumberOfTuples() == volume->GetNumberOfPoints(), "every sample has a value");
    values->GetRange(); // looks at all of them
    return;
  }
  const vtkSmartPointer<vtkPolyData> mesh = arris::ReadMesh(path, none);
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfPolys(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, ids);
    for (const vtkIdType id : *ids)
    {
      Require(id >= 0 && id < mesh->GetNumberOfPoints(), "cells name points that are there");
    }
  }
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    double p[3];
    mesh->GetPoint(v, p);
  }
}
}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  const Kind& kind = Kinds[static_cast<unsigned>(data[0] + 256 - 'a') % std::size(Kinds)];
  const std::string path = (std::filesystem::temp_directory_path() /
    ("arris-fuzz-" + std::to_string(getpid()) + kind.Extension))
                             .string();
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data + 1), size - 1);
  try
  {
    ReadAny(path, kind.IsVolume);
  }
  catch (const arris::Failure& failure)
  {
    const std::string words = failure.what();
    Require(words.find(path) == 0, "the message begins with the file");
    Require(words.find('\n') == std::string::npos, "the message is one line");
  }
  catch (const std::bad_alloc&)
  {
    // A header may promise more than there is memory; the program says so and ends.
  }
  unlink(path.c_str());
  return 0;
}
