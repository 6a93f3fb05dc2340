// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file SpatialWindow.h
/// The window of the paper's Eq. 1 found in space, by the grid of the paper's section 4.2.

#ifndef arris_SpatialWindow_h
#define arris_SpatialWindow_h

#include "Mesh.h"

#include "ArrisFiltersModule.h" // for the export macro

#include <vtkNew.h>

class vtkIdList;
class vtkPolyData;
class vtkStaticCellLocator;

namespace arris
{
/// The triangles of a mesh sorted into cubes about as wide as the window. Built once, then read by
/// any number of threads.
class ARRISFILTERS_EXPORT WindowGrid
{
public:
  WindowGrid(const Mesh& mesh, double radius);
  ~WindowGrid();
  WindowGrid(const WindowGrid&) = delete;
  void operator=(const WindowGrid&) = delete;

private:
  friend class SpatialWindow;
  vtkNew<vtkPolyData> Surface;
  vtkNew<vtkStaticCellLocator> Locator;
};

/// Gathers the triangles within a distance of a vertex, whether or not the surface connects them.
/// In an assembly, those of the patches that hold the vertex. Keeps its working memory from one
/// vertex to the next: use one object a thread.
class ARRISFILTERS_EXPORT SpatialWindow
{
public:
  SpatialWindow(const Mesh& mesh, const Connectivity& connectivity, const WindowGrid& grid);
  ~SpatialWindow();

  /// The triangles of the window, ascending. Valid until the next call.
  const std::vector<Index>& Gather(Index vertex, double radius);

private:
  bool SharesPatch(Index vertex, Index triangle) const;

  const Mesh& TheMesh;
  const Connectivity& TheConnectivity;
  const WindowGrid& Grid;
  vtkNew<vtkIdList> Found;
  std::vector<Index> Window;
};
}

#endif
