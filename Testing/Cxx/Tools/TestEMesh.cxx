// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EMesh.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

TEST(EMesh, HasAnEdgeOfTwoCurvesOnce)
{
  // Each curve has points of its own: (0 0 0) to (1 0 0) is in both.
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const double y : { 1.0, -1.0 })
  {
    const vtkIdType ids[] = { points->InsertNextPoint(0.0, 0.0, 0.0),
      points->InsertNextPoint(1.0, 0.0, 0.0), points->InsertNextPoint(1.0, y, 0.0) };
    lines->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> curves;
  curves->SetPoints(points);
  curves->SetLines(lines);

  const std::string path = std::filesystem::temp_directory_path() / "arris-test.eMesh";
  arris::WriteEMesh(curves, path);
  std::ifstream file(path);
  const std::string text{ std::istreambuf_iterator<char>(file), {} };
  std::filesystem::remove(path);
  EXPECT_NE(text.find("// points:\n4\n("), std::string::npos) << text;
  EXPECT_NE(text.find("// edges:\n3\n(\n(0 1)\n(1 2)\n(1 3)\n)"), std::string::npos) << text;
}
