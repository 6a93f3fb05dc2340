// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Parameters.h
/// Defaults and ranges of the paper's two parameters, in one place for all filters.

#ifndef arris_Parameters_h
#define arris_Parameters_h

#include "Core/Ussod.h"

#include <cmath>
#include <initializer_list>
#include <sstream>
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

/// Kinks of edges shorter than this, in average edge lengths, split no curve: they are small enough
/// to be the mesh's, not the part's.
constexpr double CornerReach = 0.25;

/// Up to there a feature goes on where it ends, as a part of the feature angle.
constexpr double DefaultContinuation = 0.5;

/// Where the mesh folds up and down by more than an edge's angle over this, the edge may be noise.
/// Noise of a tenth of an edge turns a triangle over now and then: a fold of 150 degrees, 20 times
/// that of the edges around.
constexpr double DefaultNoiseFactor = 30.0;

/// Gaps that are closed and tails that are cut by themselves, in average edge lengths.
constexpr double DefaultGap = 1.0;
constexpr double DefaultTail = 2.0;

/// Where the surface still folds between, gaps of so many times the length are closed.
constexpr double FoldedGap = 5.0;

/// Where a mesh has been recovered, what ends freely away from all edges that were is cut up to
/// this, in average edge lengths.
constexpr double UnlikelyTail = 10.0;

/// Points on open edges that are nearer than this are one, as a part of the diagonal of the mesh's
/// bounding box: ten times what single precision tells apart.
constexpr double DefaultMergeTolerance = 1e-6;

/// How near a shape must be to a face to fit it (RMS), in the face's mean edge lengths.
constexpr double DefaultFitTolerance = 0.03;

/// Lengths that can be reckoned with, whatever their unit: up to their sixth powers stay within the
/// range of double precision.
constexpr double LargestLength = 1e50;
constexpr double SmallestLength = 1e-50;

/// The largest coordinate in single precision, so that a vertex that moves by a few edges stays
/// within its range, too.
constexpr double LargestSingle = 1e36;

/// Whether a number is a length, or a ratio of lengths, in that range.
inline bool IsLength(double value)
{
  return value >= SmallestLength && value <= LargestLength;
}

/// The window radius in units of length: as given, or by the ratio where none is given.
inline double WindowRadius(double window, double ratio, double averageEdgeLength)
{
  return window > 0.0 ? window : ratio * averageEdgeLength;
}

/// A number as messages show it: short, whatever its size.
inline std::string Written(double value)
{
  std::ostringstream words;
  words << value;
  return words.str();
}

/// What is wrong with a number that must be above 0, or nothing.
inline std::string ProblemWithRatio(const char* name, double value)
{
  return IsLength(value)
    ? std::string()
    : std::string(name) + " must be greater than 0, from 1e-50 to 1e50; it is " + Written(value);
}

/// What is wrong with the size of the window, or nothing.
inline std::string ProblemWithWindow(double window, double ratio)
{
  if (window != 0.0 && !IsLength(window))
  {
    return "Window must be a length, from 1e-50 to 1e50, or 0 to use WindowRatio; it is " +
      Written(window);
  }
  return window == 0.0 ? ProblemWithRatio("WindowRatio", ratio) : std::string();
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

/// What is wrong with a window that may be left to the method, or nothing.
inline std::string ProblemWithOptionalWindow(double window, double ratio, int search)
{
  return ProblemWithWindow(window, ratio == 0.0 ? DefaultWindowRatio : ratio, search);
}

/// What is wrong with an angle, or nothing.
inline std::string ProblemWithAngle(const char* name, double degrees)
{
  if (!(degrees > 0.0 && degrees <= 180.0))
  {
    return std::string(name) + " must be greater than 0 and at most 180 degrees; it is " +
      Written(degrees);
  }
  return {};
}

/// What is wrong with an angle of which 0 leaves it to the method, or nothing.
inline std::string ProblemWithOptionalAngle(const char* name, double degrees)
{
  return degrees == 0.0 ? std::string() : ProblemWithAngle(name, degrees);
}

/// What is wrong with a number that must not be below 0, or nothing.
inline std::string ProblemWithSize(const char* name, double value)
{
  if (!(value >= 0.0 && value <= LargestLength))
  {
    return std::string(name) + " must be a number that is not negative, up to 1e50; it is " +
      Written(value);
  }
  return {};
}

/// What is wrong with a length of which a negative one means that it is found automatically.
inline std::string ProblemWithLength(const char* name, double value)
{
  return std::isfinite(value) && value <= LargestLength ? std::string()
                                                        : std::string(name) +
      " must be a length up to 1e50, or negative for automatic; it is " + Written(value);
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
