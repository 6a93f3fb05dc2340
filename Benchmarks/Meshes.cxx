// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes.h"

#include "vtkSharpEdgeReconstruction.h"

#include <Eigen/Geometry>

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkQuadricDecimation.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace arris
{
namespace benchmarks
{
namespace
{
using Point = Eigen::Vector3d;

double OfBox(const Point& p, const Point& halfSize)
{
  return (p.cwiseAbs() - halfSize).maxCoeff();
}

/// About the signed distance to a bearing block: a foot, a boss on it, a bore through the boss, a
/// slot in the foot and the dent of a ball. Negative inside.
double OfPart(const Point& p)
{
  const double aside = std::hypot(p.x(), p.z() - 0.1);
  const double foot = OfBox(p - Point(0.0, 0.0, -0.55), Point(0.8, 0.55, 0.15));
  const double boss = std::max(aside - 0.5, std::abs(p.y()) - 0.45);
  const double web = OfBox(p - Point(0.0, 0.0, -0.25), Point(0.35, 0.3, 0.25));
  const double bore = 0.3 - aside;
  const double slot = -OfBox(p - Point(0.62, 0.0, -0.55), Point(0.08, 0.25, 0.5));
  const double dent = 0.25 - (p - Point(-0.62, 0.2, -0.35)).norm();
  return std::max({ std::min({ foot, boss, web }), bore, slot, dent });
}

/// Triangles of the contour over the square of the samples a side: measured, as the surface is.
constexpr double TrianglesPerSquaredSample = 5.1;

vtkSmartPointer<vtkPolyData> Contour(int thousands)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(Volume(thousands));
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

vtkSmartPointer<vtkPolyData> Decimated(vtkPolyData* mesh)
{
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(mesh);
  decimation->SetTargetReduction(0.5);
  decimation->Update();
  return decimation->GetOutput();
}

vtkSmartPointer<vtkPolyData> Shuffled(vtkPolyData* mesh)
{
  std::mt19937 random(1);
  std::vector<vtkIdType> newNumber(mesh->GetNumberOfPoints());
  std::iota(newNumber.begin(), newNumber.end(), 0);
  std::shuffle(newNumber.begin(), newNumber.end(), random);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(newNumber[i], mesh->GetPoint(i));
  }
  std::vector<vtkIdType> order(mesh->GetNumberOfPolys());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  vtkNew<vtkCellArray> triangles;
  for (const vtkIdType t : order)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(t, count, ids);
    triangles->InsertNextCell({ newNumber[ids[0]], newNumber[ids[1]], newNumber[ids[2]] });
  }
  const auto shuffled = vtkSmartPointer<vtkPolyData>::New();
  shuffled->SetPoints(points);
  shuffled->SetPolys(triangles);
  return shuffled;
}

vtkSmartPointer<vtkPolyData> SideBySide(vtkPolyData* mesh, int copies)
{
  vtkNew<vtkAppendPolyData> append;
  for (int i = 0; i < copies; ++i)
  {
    vtkNew<vtkPoints> points;
    points->DeepCopy(mesh->GetPoints());
    for (vtkIdType v = 0; v < points->GetNumberOfPoints(); ++v)
    {
      const double* p = mesh->GetPoint(v);
      points->SetPoint(v, p[0] + 2.0 * i, p[1], p[2]);
    }
    vtkNew<vtkPolyData> copy;
    copy->SetPoints(points);
    copy->SetPolys(mesh->GetPolys());
    append->AddInputData(copy);
  }
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkPolyData> Make(MeshKind kind, int thousands)
{
  constexpr int Most = 1000;
  if (thousands > Most)
  {
    return SideBySide(MeshOf(kind, Most), thousands / Most);
  }
  switch (kind)
  {
    case MeshKind::Irregular:
      return Decimated(Contour(2 * thousands));
    case MeshKind::Shuffled:
      return Shuffled(MeshOf(MeshKind::Contour, thousands));
    default:
      return Contour(thousands);
  }
}
}

vtkSmartPointer<vtkImageData> Volume(int thousands)
{
  const int samples = static_cast<int>(std::sqrt(1000.0 * thousands / TrianglesPerSquaredSample));
  const double width = 2.0 / (samples - 1);
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samples, samples, samples);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(width, width, width);
  vtkNew<vtkFloatArray> distance;
  distance->SetName("Distance");
  distance->SetNumberOfValues(image->GetNumberOfPoints());
  // Off the axes and the nodes of the grid, so that nothing comes out flat by accident.
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.37, Point(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const Point offset(0.013, -0.007, 0.021);
  vtkSMPTools::For(0, samples,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        for (int j = 0; j < samples; ++j)
        {
          for (int i = 0; i < samples; ++i)
          {
            const Point p(width * i - 1.0, width * j - 1.0, width * static_cast<double>(k) - 1.0);
            distance->SetValue(
              (k * samples + j) * samples + i, static_cast<float>(OfPart(turn * (p - offset))));
          }
        }
      }
    });
  image->GetPointData()->SetScalars(distance);
  return image;
}

vtkPolyData* MeshOf(MeshKind kind, int thousands)
{
  static std::map<std::pair<MeshKind, int>, vtkSmartPointer<vtkPolyData>> made;
  vtkSmartPointer<vtkPolyData>& mesh = made[{ kind, thousands }];
  if (mesh == nullptr)
  {
    mesh = Make(kind, thousands);
  }
  return mesh;
}

vtkPolyData* RecoveredContour(int thousands)
{
  static std::map<int, vtkSmartPointer<vtkPolyData>> made;
  vtkSmartPointer<vtkPolyData>& mesh = made[thousands];
  if (mesh == nullptr)
  {
    vtkNew<vtkSharpEdgeReconstruction> recovery;
    recovery->SetMethodToPaper();
    recovery->SetInputData(MeshOf(MeshKind::Contour, thousands));
    recovery->Update();
    mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(recovery->GetOutput()->GetPoints());
    mesh->SetPolys(recovery->GetOutput()->GetPolys());
  }
  return mesh;
}
}
}
