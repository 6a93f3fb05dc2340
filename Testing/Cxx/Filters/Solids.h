// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Solids.h
/// Solids whose distance and sharp edges are known exactly, and their contours.

#ifndef arris_testing_Solids_h
#define arris_testing_Solids_h

#include <Eigen/Geometry>

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace arris
{
namespace testing
{
using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

/// A plane profile, moved along z from -HalfHeight to HalfHeight, then turned off the axes of the
/// grid and moved off its nodes.
struct Solid
{
  std::function<double(const Point2&)> Profile; ///< signed distance, positive inside
  double HalfHeight;
  std::vector<std::vector<Point2>> Outline; ///< its smooth parts, closely sampled
  bool HasCorners; ///< whether these parts meet at corners, which draw edges along z

  static Eigen::Matrix3d Rotation()
  {
    return Eigen::AngleAxisd(0.37, Point3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  }
  static Point3 Offset() { return Point3(0.013, -0.007, 0.021); }

  /// The exact distance to the surface, positive inside.
  double SignedDistance(const Point3& world) const
  {
    const Point3 p = Rotation().transpose() * (world - Offset());
    const double out2 = -this->Profile(p.head<2>());
    const double outZ = std::abs(p.z()) - this->HalfHeight;
    const double inside = std::min(0.0, std::max(out2, outZ));
    return -(inside + std::hypot(std::max(0.0, out2), std::max(0.0, outZ)));
  }

  /// Points on the sharp edges, at most `step` apart.
  std::vector<Point3> SharpEdgePoints(double step) const
  {
    std::vector<Point3> points;
    const auto add = [&](const Point2& p, double z)
    { points.emplace_back(Rotation() * Point3(p.x(), p.y(), z) + Offset()); };
    for (const std::vector<Point2>& part : this->Outline)
    {
      for (std::size_t i = 0; i + 1 < part.size(); ++i)
      {
        const int count = static_cast<int>(std::ceil((part[i + 1] - part[i]).norm() / step));
        for (int k = 0; k < count; ++k)
        {
          const Point2 p = part[i] + (part[i + 1] - part[i]) * k / count;
          add(p, -this->HalfHeight);
          add(p, this->HalfHeight);
        }
      }
      const int count = static_cast<int>(std::ceil(2.0 * this->HalfHeight / step));
      for (int k = 0; this->HasCorners && k < count; ++k)
      {
        add(part.front(), this->HalfHeight * (2.0 * k / count - 1.0));
      }
    }
    return points;
  }
};

/// The signed distance to a simple polygon, positive inside.
inline double DistanceInPolygon(const std::vector<Point2>& corners, const Point2& p)
{
  double nearest2 = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point2& a = corners[i];
    const Point2& b = corners[(i + 1) % corners.size()];
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    nearest2 = std::min(nearest2, (p - a - t * (b - a)).squaredNorm());
    const bool crosses = (a.y() > p.y()) != (b.y() > p.y());
    if (crosses && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
    {
      inside = !inside;
    }
  }
  return inside ? std::sqrt(nearest2) : -std::sqrt(nearest2);
}

inline Solid Prism(const std::vector<Point2>& corners, double halfHeight)
{
  std::vector<std::vector<Point2>> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    sides.push_back({ corners[i], corners[(i + 1) % corners.size()] });
  }
  return { [corners](const Point2& p) { return DistanceInPolygon(corners, p); }, halfHeight, sides,
    true };
}

inline Solid BoxSolid()
{
  return Prism({ { -0.6, -0.5 }, { 0.6, -0.5 }, { 0.6, 0.5 }, { -0.6, 0.5 } }, 0.45);
}

inline Solid BracketSolid()
{
  return Prism({ { -0.65, -0.6 }, { 0.65, -0.6 }, { 0.65, -0.15 }, { -0.2, -0.15 }, { -0.2, 0.6 },
                 { -0.65, 0.6 } },
    0.4);
}

/// The sides of a regular prism meet at a turn of 360 degrees by their number.
inline Solid RegularPrism(int sides)
{
  constexpr double Radius = 0.75;
  std::vector<Point2> corners;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / sides;
    corners.emplace_back(Radius * std::cos(angle), Radius * std::sin(angle));
  }
  return Prism(corners, 0.5);
}

inline Solid RoundSolid(double radius)
{
  constexpr int Steps = 2000;
  std::vector<Point2> circle;
  for (int i = 0; i <= Steps; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / Steps;
    circle.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return { [radius](const Point2& p) { return radius - p.norm(); }, 0.5, { circle }, false };
}

inline Solid CylinderSolid()
{
  return RoundSolid(0.6);
}

/// The width of a cell when `samples` points a side sample [-1, 1]^3.
inline double CellWidth(int samples)
{
  return 2.0 / (samples - 1);
}

/// The distance of a solid, positive inside, sampled in [-1, 1]^3.
inline vtkSmartPointer<vtkImageData> DistanceImage(const Solid& solid, int samples)
{
  const double width = CellWidth(samples);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samples, samples, samples);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(width, width, width);
  vtkNew<vtkFloatArray> distance;
  distance->SetName("Distance");
  distance->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    image->GetPoint(i, p.data());
    distance->SetValue(i, static_cast<float>(solid.SignedDistance(p)));
  }
  image->GetPointData()->SetScalars(distance);
  return image;
}

inline vtkSmartPointer<vtkPolyData> ContourOfImage(vtkImageData* image)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// What sampling leaves of a solid: the contour of its distance.
inline vtkSmartPointer<vtkPolyData> Contour(const Solid& solid, int samples)
{
  return ContourOfImage(DistanceImage(solid, samples));
}

inline vtkSmartPointer<vtkPolyData> ContourOfBlurred(vtkImageData* image, double width)
{
  vtkNew<vtkImageGaussianSmooth> blur;
  blur->SetInputData(image);
  blur->SetStandardDeviation(width);
  blur->SetRadiusFactor(4.0);
  blur->Update();
  return ContourOfImage(blur->GetOutput());
}

/// The same, of the distance after a Gaussian of this width (in cells) has blurred it.
inline vtkSmartPointer<vtkPolyData> BlurredContour(const Solid& solid, int samples, double width)
{
  return ContourOfBlurred(DistanceImage(solid, samples), width);
}

/// What a segmentation leaves of a solid: its samples are inside or outside, and a Gaussian of one
/// cell makes something of that to contour.
inline vtkSmartPointer<vtkPolyData> SegmentedContour(const Solid& solid, int samples)
{
  const vtkSmartPointer<vtkImageData> image = DistanceImage(solid, samples);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i, values->GetTuple1(i) > 0.0 ? 1.0 : -1.0);
  }
  return ContourOfBlurred(image, 1.0);
}
}
}

#endif
