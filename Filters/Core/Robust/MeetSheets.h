// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file MeetSheets.h
/// Where the vertices of the region belong: on their sheet, on the ridge of two, in the corner of
/// three or more.

#ifndef arris_Robust_MeetSheets_h
#define arris_Robust_MeetSheets_h

#include "Sheet.h"

#include "ArrisFiltersModule.h" // for the export macro

namespace arris
{
/// Normals closer than this are one face for the purpose of edges, in degrees.
constexpr double LeastCrossingAngle = 15.0;

/// The point nearest to `start` that lies on all the sheets, or as near to all of them as can be.
/// Sheets that have a curve in common, however many they are, leave its direction free: `most`
/// tells how many directions they determine at most.
ARRISFILTERS_EXPORT Vec3 MeetSheets(
  const Vec3& start, const std::vector<const Sheet*>& sheets, int most = 3);

/// Whether one of `others` has about the normal that the sheet has at a point, so that the two have
/// no edge to meet in.
bool IsSpokenFor(const Sheet& sheet, const std::vector<const Sheet*>& others, const Vec3& point);
}

#endif
