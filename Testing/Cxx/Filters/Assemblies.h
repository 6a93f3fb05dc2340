// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Assemblies.h
/// The surfaces between several materials, sampled as surface nets do.

#ifndef arris_testing_Assemblies_h
#define arris_testing_Assemblies_h

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <vector>

namespace arris
{
namespace testing
{
using Point = Eigen::Vector3d;

/// How deep a point is inside a material; negative outside.
using Material = std::function<double(const Point&)>;

/// Cells a side for which no edge of the net of TwoSlabs has four faces between the same materials.
constexpr int CleanCells = 28;

/// The planes of two slabs on each other, turned so that none lies along the grid: |x| <= 6,
/// |y| <= 5, -4 <= z <= 1 and 1 <= z <= 4.
struct TwoSlabs
{
  Eigen::Matrix3d Turn = (Eigen::AngleAxisd(0.15, Point::UnitX()) *
    Eigen::AngleAxisd(0.1, Point::UnitY()) * Eigen::AngleAxisd(0.1, Point::UnitZ()))
                           .toRotationMatrix();

  static double InBox(const Point& p, double low, double high)
  {
    return std::min({ 6.0 - std::abs(p.x()), 5.0 - std::abs(p.y()), p.z() - low, high - p.z() });
  }
  Point Local(const Point& p) const { return this->Turn.transpose() * p; }

  std::vector<Material> Materials() const
  {
    return { [this](const Point& p) { return -InBox(this->Local(p), -4.0, 4.0); },
      [this](const Point& p) { return InBox(this->Local(p), -4.0, 1.0); },
      [this](const Point& p) { return InBox(this->Local(p), 1.0, 4.0); } };
  }
};

/// One vertex in each cell of several materials, at the mean of where the cell's edges go from one
/// to another; a face for each of these edges; PatchId tells the pair of materials. The cube from
/// -10 to 10 has `cells` cells a side.
class SurfaceNet
{
public:
  SurfaceNet(const std::vector<Material>& materials, int cells)
    : Materials(materials)
    , Cells(cells)
    , VertexOf(static_cast<std::size_t>(cells) * cells * cells, -1)
  {
  }

  vtkSmartPointer<vtkPolyData> Make()
  {
    this->ForEachCrossing([this](const Crossing& crossing) { this->AddToVertices(crossing); });
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (std::size_t v = 0; v < this->Sums.size(); ++v)
    {
      points->InsertNextPoint(Point(this->Sums[v] / this->Counts[v]).data());
    }
    vtkNew<vtkCellArray> triangles;
    vtkNew<vtkIntArray> ids;
    ids->SetName("PatchId");
    this->ForEachCrossing(
      [&](const Crossing& crossing)
      {
        std::array<vtkIdType, 4> quad;
        for (int k = 0; k < 4; ++k)
        {
          quad[k] = this->VertexOf[this->CellAround(crossing, crossing.Up ? k : 3 - k)];
        }
        for (const auto& corners : { std::array<int, 3>{ 0, 1, 2 }, std::array<int, 3>{ 0, 2, 3 } })
        {
          const vtkIdType cell[3] = { quad[corners[0]], quad[corners[1]], quad[corners[2]] };
          triangles->InsertNextCell(3, cell);
          ids->InsertNextValue(crossing.Pair);
        }
      });
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(triangles);
    mesh->GetCellData()->AddArray(ids);
    return mesh;
  }

private:
  struct Crossing
  {
    std::array<int, 3> Start;
    int Axis;
    double Where; ///< from the start, in cells
    int Pair;
    bool Up; ///< from the lower material to the higher
  };

  Point At(const std::array<int, 3>& node) const
  {
    return Point(node[0], node[1], node[2]) * (20.0 / this->Cells) - Point::Constant(10.0);
  }

  int MaterialAt(const Point& p) const
  {
    int best = 0;
    for (std::size_t m = 1; m < this->Materials.size(); ++m)
    {
      best = this->Materials[m](p) > this->Materials[best](p) ? static_cast<int>(m) : best;
    }
    return best;
  }

  template <typename Visit>
  void ForEachCrossing(Visit&& visit) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      std::array<int, 3> node;
      for (node[0] = 1; node[0] < this->Cells; ++node[0])
      {
        for (node[1] = 1; node[1] < this->Cells; ++node[1])
        {
          for (node[2] = 1; node[2] < this->Cells; ++node[2])
          {
            std::array<int, 3> end = node;
            ++end[axis];
            const Point p = this->At(node), q = this->At(end);
            const int a = this->MaterialAt(p), b = this->MaterialAt(q);
            if (a != b)
            {
              const double before = this->Materials[a](p) - this->Materials[b](p);
              const double after = this->Materials[a](q) - this->Materials[b](q);
              visit(Crossing{ node, axis, before / (before - after),
                10 * std::min(a, b) + std::max(a, b), a < b });
            }
          }
        }
      }
    }
  }

  std::size_t CellAround(const Crossing& crossing, int k) const
  {
    std::array<int, 3> cell = crossing.Start;
    cell[(crossing.Axis + 1) % 3] -= k == 1 || k == 2 ? 1 : 0;
    cell[(crossing.Axis + 2) % 3] -= k == 2 || k == 3 ? 1 : 0;
    return (static_cast<std::size_t>(cell[0]) * this->Cells + cell[1]) * this->Cells + cell[2];
  }

  void AddToVertices(const Crossing& crossing)
  {
    std::array<int, 3> end = crossing.Start;
    ++end[crossing.Axis];
    const Point p =
      (1.0 - crossing.Where) * this->At(crossing.Start) + crossing.Where * this->At(end);
    for (int k = 0; k < 4; ++k)
    {
      vtkIdType& vertex = this->VertexOf[this->CellAround(crossing, k)];
      if (vertex < 0)
      {
        vertex = static_cast<vtkIdType>(this->Sums.size());
        this->Sums.emplace_back(Point::Zero());
        this->Counts.push_back(0);
      }
      this->Sums[vertex] += p;
      ++this->Counts[vertex];
    }
  }

  std::vector<Material> Materials;
  int Cells;
  std::vector<vtkIdType> VertexOf;
  std::vector<Point> Sums;
  std::vector<int> Counts;
};
}
}

#endif
