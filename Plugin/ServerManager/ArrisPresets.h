// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file ArrisPresets.h
/// The colour maps of the arrays that Arris adds.

#ifndef ArrisPresets_h
#define ArrisPresets_h

#include "ArrisServerManagerModule.h" // for the export macro

/// Adds the plugin's colour map presets to ParaView's, and makes them those that the arrays
/// NormalDeviation and SkeletonRole get by themselves, unless the user has chosen others. Called
/// when the plugin is loaded.
ARRISSERVERMANAGER_EXPORT void ArrisRegisterPresets();

#endif
