// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EMesh.h"

#include "AtomicFile.h"
#include "Segments.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace arris
{
namespace
{
using Point = std::array<double, 3>;

/// Curves as points and edges between them, each of them once: curves may have their last edge in
/// common.
struct Edges
{
  std::vector<Point> Points;
  std::vector<std::array<std::size_t, 2>> Ends;

  explicit Edges(vtkPolyData* curves)
  {
    std::map<Point, std::size_t> known;
    const auto number = [&](vtkIdType id)
    {
      Point point;
      curves->GetPoint(id, point.data());
      const auto inserted = known.insert({ point, this->Points.size() });
      if (inserted.second)
      {
        this->Points.push_back(point);
      }
      return inserted.first->second;
    };
    std::set<std::pair<std::size_t, std::size_t>> seen;
    ForEachSegment(curves,
      [&](vtkIdType a, vtkIdType b)
      {
        const std::size_t from = number(a);
        const std::size_t to = number(b);
        if (seen.insert(std::minmax(from, to)).second)
        {
          this->Ends.push_back({ from, to });
        }
      });
  }
};

/// What OpenFOAM takes for a word: the name of the file without what would end it.
std::string ObjectName(const std::string& path)
{
  std::string name = std::filesystem::path(path).filename().string();
  for (char& letter : name)
  {
    const bool ends = std::string(" \t\n\"'/;{}()").find(letter) != std::string::npos;
    letter = ends ? '_' : letter;
  }
  return name;
}
}

void WriteEMesh(vtkPolyData* curves, const std::string& path)
{
  const Edges edges(curves);
  WriteAtomically(path,
    [&](const std::string& scratch)
    {
      std::ofstream out(scratch, std::ios::binary);
      out.precision(std::numeric_limits<double>::max_digits10);
      out << "FoamFile\n{\n"
          << "    version     2.0;\n"
          << "    format      ascii;\n"
          << "    class       featureEdgeMesh;\n"
          << "    object      " << ObjectName(path) << ";\n}\n\n";
      out << "// points:\n" << edges.Points.size() << "\n(\n";
      for (const Point& point : edges.Points)
      {
        out << "(" << point[0] << " " << point[1] << " " << point[2] << ")\n";
      }
      out << ")\n\n// edges:\n" << edges.Ends.size() << "\n(\n";
      for (const auto& ends : edges.Ends)
      {
        out << "(" << ends[0] << " " << ends[1] << ")\n";
      }
      out << ")\n";
    });
}
}
