// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Parameters.h
/// Defaults and ranges of the paper's two parameters, in one place for all filters.

#ifndef arris_Parameters_h
#define arris_Parameters_h

#include "Core/Ussod.h"

#include <cmath>
#include <initializer_list>
#include <string>

namespace arris
{
/// The window radius λ as a multiple of the average edge length. The paper uses 0.5 to 1.5.
constexpr double DefaultWindowRatio = 0.75;

/// acos(0.75): the paper's κλ = 0.25, in degrees.
constexpr double DefaultSharpAngle = 41.4096221092709;

/// Where edges of a recovered mesh count as features, in degrees; vtkFeatureEdges has the same.
constexpr double DefaultFeatureAngle = 30.0;

/// Where a feature curve turns so much that it is split, in degrees.
constexpr double DefaultCornerAngle = 60.0;

/// The window radius in units of length: as given, or by the ratio where none is given.
inline double WindowRadius(double window, double ratio, double averageEdgeLength)
{
  return window > 0.0 ? window : ratio * averageEdgeLength;
}

/// What is wrong with the size of the window, or nothing.
inline std::string ProblemWithWindow(double window, double ratio)
{
  if (!std::isfinite(window) || window < 0.0)
  {
    return "Window must be a length, or 0 to use WindowRatio; it is " + std::to_string(window);
  }
  if (window == 0.0 && !(std::isfinite(ratio) && ratio > 0.0))
  {
    return "WindowRatio must be greater than 0; it is " + std::to_string(ratio);
  }
  return {};
}

/// What is wrong with the window and how it is searched, or nothing.
inline std::string ProblemWithWindow(double window, double ratio, int search)
{
  if (search != static_cast<int>(WindowSearch::Connected) &&
    search != static_cast<int>(WindowSearch::Spatial))
  {
    return "WindowSearch must be 0 (connected) or 1 (spatial); it is " + std::to_string(search);
  }
  return ProblemWithWindow(window, ratio);
}

/// What is wrong with an angle, or nothing.
inline std::string ProblemWithAngle(const char* name, double degrees)
{
  if (!(degrees > 0.0 && degrees <= 180.0))
  {
    return std::string(name) + " must be greater than 0 and at most 180 degrees; it is " +
      std::to_string(degrees);
  }
  return {};
}

/// The first of some problems that is not empty; else what `check` says, which runs only then.
template <typename Check>
std::string FirstProblem(std::initializer_list<std::string> problems, Check&& check)
{
  for (const std::string& problem : problems)
  {
    if (!problem.empty())
    {
      return problem;
    }
  }
  return check();
}
}

#endif
