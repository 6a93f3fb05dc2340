// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ComparisonReport.h
/// Comparisons as tables and as JSON.

#ifndef arris_ComparisonReport_h
#define arris_ComparisonReport_h

#include "Comparison.h"
#include "Session.h"

namespace arris
{
/// Lengths, and percent of the diagonal.
Session::Json ToJson(const Comparison& comparison);

/// Prints the comparison as a table.
void SayComparison(const Session& session, const Comparison& comparison);
}

#endif
