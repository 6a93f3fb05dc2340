// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Accuracy.h
/// What a method makes of contours at 64^3 of solids that are turned off the grid.

#ifndef arris_testing_Accuracy_h
#define arris_testing_Accuracy_h

#include "Distances.h"

namespace arris
{
namespace testing
{
/// A solid, and the least that must be recovered of it, in whatever a test measures.
struct Model
{
  const char* Name;
  Solid (*Make)();
  double Least;
};
inline std::ostream& operator<<(std::ostream& os, const Model& model)
{
  return os << model.Name;
}
inline std::string ModelName(const ::testing::TestParamInfo<Model>& test)
{
  return test.param.Name;
}

/// A model's contour, and what `Recover` makes of it.
template <vtkSmartPointer<vtkPolyData> (*Recover)(vtkPolyData*)>
class RecoveredModel : public ::testing::TestWithParam<Model>
{
protected:
  static constexpr int Samples = 64;
  const Solid Truth = GetParam().Make();
  const vtkSmartPointer<vtkPolyData> Before = Contour(this->Truth, Samples);
  const vtkSmartPointer<vtkPolyData> After = Recover(this->Before);

  /// How many times nearer to the truth it comes in the mean.
  double Improvement() const { return this->Mean(this->Before) / this->Mean(this->After); }

  /// The part of the true sharp edges that is there within 0.1 cell.
  double Found(vtkPolyData* mesh) const
  {
    const double width = CellWidth(Samples);
    return Recall(mesh, this->Truth.SharpEdgePoints(0.05 * width), 0.1 * width);
  }

private:
  double Mean(vtkPolyData* mesh) const
  {
    return MeanDistance<3>(mesh, [this](const Point3& p) { return this->Truth.SignedDistance(p); });
  }
};
}
}

#endif
