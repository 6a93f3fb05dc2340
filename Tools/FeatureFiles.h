// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file FeatureFiles.h
/// Curves, corners and faces in the formats that their users need.

#ifndef arris_FeatureFiles_h
#define arris_FeatureFiles_h

#include "FeatureStage.h"

namespace arris
{
class ProgressBar;

// .vtp and .vtk with all arrays; .obj with lines, or points; .eMesh for OpenFOAM; .csv with a row a
// curve, corner or face. Each throws a Failure where it cannot be written.

/// .vtp .vtk .obj .csv .eMesh
void CheckCurvesOutput(const std::string& path);
void WriteCurves(const Features& found, const std::string& path, ProgressBar& progress);

/// .vtp .vtk .obj .csv
void CheckCornersOutput(const std::string& path);
void WriteCorners(const Features& found, const std::string& path, ProgressBar& progress);

/// .csv
void CheckFacesOutput(const std::string& path);
void WriteFaces(const Features& found, const std::string& path);
}

#endif
