// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Distances.h"

using namespace arris::testing;

// A guard of what the paper's method reaches with its defaults on contours at 64^3, each solid
// turned off the grid. Promised are half the mean distance and 72 % of the sharp edges; what it
// reaches now is more (20, 2.5 and 12 times nearer, 95, 95 and 92 %), and the limits lie between.

namespace
{
struct Model
{
  const char* Name;
  Solid (*Make)();
  double LeastImprovement;
};
std::ostream& operator<<(std::ostream& os, const Model& model)
{
  return os << model.Name;
}

class Accuracy : public ::testing::TestWithParam<Model>
{
protected:
  static constexpr int Samples = 64;
  const Solid Truth = GetParam().Make();
  const vtkSmartPointer<vtkPolyData> Before = Contour(this->Truth, Samples);
  const vtkSmartPointer<vtkPolyData> After = RecoverByPaper(this->Before);

  double Mean(vtkPolyData* mesh) const
  {
    return MeanDistance<3>(mesh, [this](const Point3& p) { return this->Truth.SignedDistance(p); });
  }
};
}

TEST_P(Accuracy, ComesNearerToTheTruthInTheMean)
{
  const double before = this->Mean(this->Before);
  const double after = this->Mean(this->After);
  this->RecordProperty("times", std::to_string(before / after));
  EXPECT_GE(before / after, GetParam().LeastImprovement);
}

TEST_P(Accuracy, MostOfTheSharpEdgesAreBack)
{
  const double width = CellWidth(Samples);
  const std::vector<Point3> truth = this->Truth.SharpEdgePoints(0.05 * width);
  const double before = Recall(this->Before, truth, 0.1 * width);
  const double after = Recall(this->After, truth, 0.1 * width);
  this->RecordProperty("recall", std::to_string(after));
  EXPECT_LE(before, 0.2) << "or the contour did not lose them";
  EXPECT_GE(after, 0.85);
}

INSTANTIATE_TEST_SUITE_P(Solids, Accuracy,
  ::testing::Values(Model{ "Box", BoxSolid, 5.0 }, Model{ "Cylinder", CylinderSolid, 2.0 },
    Model{ "Bracket", BracketSolid, 5.0 }),
  [](const auto& test) { return test.param.Name; });
