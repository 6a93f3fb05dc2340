// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ObjCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace arris
{
namespace
{
/// Vertices, texture coordinates and normals: what a corner "1/2/3" names one of each of.
constexpr int Kinds = 3;
constexpr std::array<const char*, Kinds> Keywords = { "v", "vt", "vn" };
constexpr std::array<int, Kinds> FewestNumbers = { 3, 1, 3 };

class ObjReader
{
public:
  /// What is wrong with a line, or nothing.
  std::string Read(const std::string& line)
  {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    for (int kind = 0; kind < Kinds; ++kind)
    {
      if (keyword == Keywords[kind])
      {
        ++this->Counts[kind];
        return this->ReadNumbers(words, FewestNumbers[kind]);
      }
    }
    return keyword == "f" || keyword == "l" || keyword == "p" ? this->ReadCorners(words) : "";
  }

  /// What is wrong with the whole, or nothing.
  std::string Finish() const
  {
    for (int kind = 0; kind < Kinds; ++kind)
    {
      if (this->Largest[kind] > this->Counts[kind])
      {
        return "a face names " + std::string(Keywords[kind]) + " " +
          std::to_string(this->Largest[kind]) + ", but there are " +
          std::to_string(this->Counts[kind]);
      }
    }
    return {};
  }

  std::array<vtkIdType, Kinds> Counts = {};

private:
  std::string ReadNumbers(std::istringstream& words, int fewest) const
  {
    std::string word;
    for (int i = 0; i < fewest; ++i)
    {
      word.clear();
      words >> word;
      char* end = nullptr;
      if (!std::isfinite(std::strtod(word.c_str(), &end)) || end == word.c_str() || *end != '\0')
      {
        return "does not hold " + std::to_string(fewest) + " finite numbers";
      }
    }
    return {};
  }

  std::string ReadCorners(std::istringstream& words)
  {
    int corners = 0;
    for (std::string word; words >> word && word != "\\"; ++corners)
    {
      const char* text = word.c_str();
      for (int kind = 0; kind < Kinds; ++kind)
      {
        char* end = nullptr;
        const vtkIdType index = std::strtoll(text, &end, 10);
        const bool given = end != text;
        if ((!given && kind == 0) || (given && !this->IsIndex(index, kind)))
        {
          return "names '" + word + "', which is not there";
        }
        if (*end != '/')
        {
          break;
        }
        text = end + 1;
      }
    }
    return corners > 0 ? "" : "names no vertices";
  }

  /// Whether an index counts from the first, or below 0 back from the last so far.
  bool IsIndex(vtkIdType index, int kind)
  {
    this->Largest[kind] = std::max(this->Largest[kind], index);
    return index > 0 || (index < 0 && index >= -this->Counts[kind]);
  }

  std::array<vtkIdType, Kinds> Largest = {};
};
}

ObjCheck CheckObj(const std::string& path)
{
  ObjCheck check;
  ObjReader reader;
  std::ifstream file(path);
  vtkIdType number = 1;
  for (std::string line; check.Problem.empty() && std::getline(file, line); ++number)
  {
    const std::string problem = reader.Read(line);
    if (!problem.empty())
    {
      check.Problem = "line " + std::to_string(number) + " " + problem;
    }
  }
  if (check.Problem.empty())
  {
    check.Problem = reader.Finish();
  }
  check.VertexCount = reader.Counts[0];
  return check;
}
}
