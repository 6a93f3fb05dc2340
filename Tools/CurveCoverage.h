// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file CurveCoverage.h
/// How much of some curves lies near other curves.

#ifndef arris_CurveCoverage_h
#define arris_CurveCoverage_h

class vtkPolyData;

namespace arris
{
/// The share, from 0 to 1, of the length of `curves` that is within `distance` of one of `others`.
/// 0 if either has no length. Lines and polylines count. With true edges as `curves` and those of a
/// mesh as `others` it is the recall; the other way round, the precision.
double CurveCoverage(vtkPolyData* curves, vtkPolyData* others, double distance);
}

#endif
