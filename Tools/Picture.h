// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Picture.h
/// Draws meshes and feature curves into a PNG file.

#ifndef arris_Picture_h
#define arris_Picture_h

#include <array>
#include <string>
#include <vector>

class vtkPolyData;

namespace arris
{
/// From where a mesh is seen, and how much of it.
struct View
{
  std::array<double, 3> From = { -0.7, 1.0, 0.65 }; ///< direction from the mesh to the eye
  std::array<double, 3> Up = { 0.0, 0.0, 1.0 };

  /// What is in the middle, in parts of the whole picture's width and height, and how much of its
  /// size is seen. The whole picture holds the mesh with little around it.
  std::array<double, 2> Middle = { 0.5, 0.5 };
  double Extent = 1.0;
};

/// What is seen in one part of a picture.
struct Scene
{
  std::string Title; ///< written in the upper left corner
  vtkPolyData* Mesh; ///< flat shaded, so that every triangle is seen
  vtkPolyData* Curves = nullptr; ///< drawn over the mesh
  vtkPolyData* Corners = nullptr; ///< drawn over the mesh
  bool ByNumber = false; ///< each curve in a colour of its own, corners by kind
  View Eye = View();
};

/// Throws a Failure if no picture can be written there.
void CheckPictureOutput(const std::string& path);

/// Draws the scenes in rows of so many, from the top. Throws a Failure if that or writing the file
/// does not work. Only where CanDraw() says so.
void DrawPicture(const std::string& path, const std::vector<Scene>& scenes, int columns = 1);
}

#endif
