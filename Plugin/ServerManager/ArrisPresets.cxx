// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ArrisPresets.h"

#include "NormalDeviationPreset.h"
#include "SkeletonRolePreset.h"

#include <vtkSMSettings.h>
#include <vtkSMTransferFunctionPresets.h>

#include <string>

namespace
{
/// Below what the user has set.
constexpr double Priority = 0.5;

/// Adds a preset unless there is one of its name, and takes it for arrays of that name.
void Register(const char* name, const std::string& preset, const std::string& arrayName)
{
  vtkSMTransferFunctionPresets* presets = vtkSMTransferFunctionPresets::GetInstance();
  if (!presets->HasPreset(name))
  {
    presets->AddPreset(name, preset);
  }
  vtkSMSettings::GetInstance()->AddCollectionFromString(
    "{ \"standard_presets\": { \"" + arrayName + "\": \"" + name + "\" } }", Priority);
}
}

void ArrisRegisterPresets()
{
  Register("Arris Normal Deviation", NormalDeviationPreset, "NormalDeviation");
  Register("Arris Skeleton Role", SkeletonRolePreset, "SkeletonRole");
}
