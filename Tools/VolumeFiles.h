// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file VolumeFiles.h
/// Reads volumes, in the format that the extension of the name tells.

#ifndef arris_VolumeFiles_h
#define arris_VolumeFiles_h

#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;

namespace arris
{
class ProgressBar;

/// Reads a volume from .vti .mha .mhd .nrrd .vtk; throws a Failure if there is none with values and
/// at least two samples in each direction.
vtkSmartPointer<vtkImageData> ReadVolume(const std::string& path, ProgressBar& progress);
}

#endif
