// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

// The sharp edges of a triangle mesh by CGAL, for curves.py: see the README.
//
//   cgal_edges MESH.off DEGREES REPEATS EDGES
//
// writes a row "vertex vertex" for each edge, the vertices counted from 0 in the file's order, and
// prints the seconds that detecting them took, and segmenting by them, each the median of repeats.

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace
{
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <typename Work>
double MedianSeconds(int repeats, Work&& work)
{
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    work();
    seconds.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (argc != 5 || !(std::ifstream(argv[1]) >> mesh))
  {
    std::cerr << "usage: cgal_edges MESH.off DEGREES REPEATS EDGES\n";
    return 1;
  }
  const double angle = std::atof(argv[2]);
  const int repeats = std::max(1, std::atoi(argv[3]));
  auto isSharp = mesh.add_property_map<Mesh::Edge_index, bool>("sharp", false).first;
  auto patches = mesh.add_property_map<Mesh::Face_index, int>("patch", 0).first;
  namespace PMP = CGAL::Polygon_mesh_processing;
  const double detecting =
    MedianSeconds(repeats, [&] { PMP::detect_sharp_edges(mesh, angle, isSharp); });
  const double segmenting =
    MedianSeconds(repeats, [&] { PMP::sharp_edges_segmentation(mesh, angle, isSharp, patches); });
  std::ofstream out(argv[4]);
  for (const auto edge : mesh.edges())
  {
    if (isSharp[edge])
    {
      const auto half = mesh.halfedge(edge);
      out << int(mesh.source(half)) << ' ' << int(mesh.target(half)) << '\n';
    }
  }
  std::cout << detecting << ' ' << segmenting << '\n';
  return out ? 0 : 1;
}
