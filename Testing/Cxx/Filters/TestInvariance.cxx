// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Assemblies.h"
#include "FilterTesting.h"

#include <vtkReverseSense.h>

#include <numeric>
#include <random>

using namespace arris::testing;

// The same part elsewhere, turned, in another unit or stored in another order is the same part.
// In double precision: a turn rounds each coordinate by 1e-16 of the size of the part, and the
// predictor magnifies that by up to 200, the inverse of the smallest eigenvalue it keeps, once for
// each round, the branches and the joints: five times here. Normals of slivers add theirs. 3e-8 was
// measured, 5e-8 at a million times the size of the part; 1e-6 is still a ten-thousandth of an
// edge.

namespace
{
constexpr double Rounding = 1e-6;

vtkSmartPointer<vtkPolyData> DoubleContour(const Solid& solid)
{
  auto mesh = Contour(solid, 32);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(mesh->GetPoints());
  mesh->SetPoints(points);
  return mesh;
}

/// p -> scale * rotation * p + offset
struct Motion
{
  const char* Name;
  Eigen::Matrix3d Rotation;
  double Scale;
  Point3 Offset;

  Point3 operator()(const Point3& p) const
  {
    return this->Scale * (this->Rotation * p) + this->Offset;
  }
};
std::ostream& operator<<(std::ostream& os, const Motion& motion)
{
  return os << motion.Name;
}

vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, const Motion& motion)
{
  auto moved = Copy(mesh);
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    Point3 p;
    mesh->GetPoint(v, p.data());
    p = motion(p);
    moved->GetPoints()->SetPoint(v, p.data());
  }
  if (motion.Rotation.determinant() < 0.0)
  {
    vtkNew<vtkReverseSense> outward;
    outward->SetInputData(moved);
    outward->Update();
    return outward->GetOutput();
  }
  return moved;
}

const Eigen::Matrix3d Still = Eigen::Matrix3d::Identity();
const Eigen::Matrix3d Turned =
  Eigen::AngleAxisd(1.1, Point3(3.0, -1.0, 2.0).normalized()).toRotationMatrix();

const Eigen::Matrix3d Mirrored = Eigen::Vector3d(-1.0, 1.0, 1.0).asDiagonal();

class Invariance : public ::testing::TestWithParam<Motion>
{
};
}

TEST_P(Invariance, OfTheRecoveredMesh)
{
  const Motion& motion = GetParam();
  const auto mesh = DoubleContour(BracketSolid());
  const auto here = RecoverByPaper(mesh);
  const auto there = RecoverByPaper(Moved(mesh, motion));
  for (const char* name : { "SharpRegion", "ThinningRound", "SkeletonRole" })
  {
    EXPECT_TRUE(
      SameBytes(here->GetPointData()->GetArray(name), there->GetPointData()->GetArray(name)))
      << name;
  }
  double farthest = 0.0;
  double ussod = 0.0;
  for (vtkIdType v = 0; v < here->GetNumberOfPoints(); ++v)
  {
    Point3 a, b;
    here->GetPoint(v, a.data());
    there->GetPoint(v, b.data());
    farthest = std::max(farthest, (motion(a) - b).norm());
    // λτ has no unit.
    ussod = std::max(ussod,
      std::abs(here->GetPointData()->GetArray("NormalDeviation")->GetComponent(v, 0) -
        there->GetPointData()->GetArray("NormalDeviation")->GetComponent(v, 0)));
  }
  EXPECT_LE(farthest, Rounding * motion.Scale);
  EXPECT_LE(ussod, 1e-5); // degrees; slivers a thousandth of an edge high magnify roundings
}

// The robust method decides much by comparison, but sees the mesh in a frame of its own, on a grid
// that is coarser than rounding.
TEST_P(Invariance, OfAllThatTheRobustMethodRecovers)
{
  const Motion& motion = GetParam();
  const auto mesh = DoubleContour(BracketSolid());
  vtkNew<vtkSharpEdgeReconstruction> filter;
  const auto here = Execute(filter, mesh);
  const auto there = Execute(filter, Moved(mesh, motion));
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    Point3 a, b;
    here->GetPoint(v, a.data());
    there->GetPoint(v, b.data());
    EXPECT_LE((motion(a) - b).norm(), Rounding * motion.Scale);
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, Invariance,
  ::testing::Values(Motion{ "Rotation", Turned, 1.0, Point3::Zero() },
    Motion{ "Translation", Still, 1.0, Point3(10.0, -20.0, 5.0) },
    Motion{ "Thousandth", Still, 1e-3, Point3::Zero() },
    Motion{ "Thousandfold", Still, 1e3, Point3::Zero() },
    Motion{ "Billionth", Still, 1e-9, Point3::Zero() },
    Motion{ "Billionfold", Still, 1e9, Point3::Zero() },
    Motion{ "FarAway", Still, 1.0, Point3(1e6, -1e6, 1e6) },
    Motion{ "Reflection", Mirrored, 1.0, Point3::Zero() },
    Motion{ "AllAtOnce", Turned, 25.4, Point3(-3.0, 40.0, 7.0) }),
  [](const auto& test) { return test.param.Name; });

namespace
{
/// The mesh with its points, cells and corners shuffled; `place` becomes where each point went.
vtkSmartPointer<vtkPolyData> Shuffled(vtkPolyData* mesh, std::vector<vtkIdType>& place)
{
  std::mt19937 random(4);
  place.resize(mesh->GetNumberOfPoints());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  auto shuffled = Copy(mesh);
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    shuffled->GetPoints()->SetPoint(place[v], mesh->GetPoint(v));
    for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
    {
      shuffled->GetPointData()->GetArray(i)->SetTuple(
        place[v], v, mesh->GetPointData()->GetArray(i));
    }
  }
  std::vector<vtkIdType> order(mesh->GetNumberOfPolys());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : order)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    const vtkIdType triangle[] = { place[ids->GetId(1)], place[ids->GetId(2)],
      place[ids->GetId(0)] };
    const vtkIdType moved = cells->InsertNextCell(3, triangle);
    for (int i = 0; i < mesh->GetCellData()->GetNumberOfArrays(); ++i)
    {
      shuffled->GetCellData()->GetArray(i)->SetTuple(moved, cell, mesh->GetCellData()->GetArray(i));
    }
  }
  shuffled->SetPolys(cells);
  return shuffled;
}

/// All arrays of points to the last bit, and where the points are.
void ExpectSameButForOrder(
  vtkPolyData* one, vtkPolyData* shuffled, const std::vector<vtkIdType>& place)
{
  auto there = Copy(one);
  for (vtkIdType v = 0; v < one->GetNumberOfPoints(); ++v)
  {
    there->GetPoints()->SetPoint(v, shuffled->GetPoint(place[v]));
    for (int i = 0; i < one->GetPointData()->GetNumberOfArrays(); ++i)
    {
      there->GetPointData()->GetArray(i)->SetTuple(
        v, place[v], shuffled->GetPointData()->GetArray(i));
    }
  }
  EXPECT_TRUE(SameBytes(one->GetPoints()->GetData(), there->GetPoints()->GetData()));
  ExpectSameArrays(one->GetPointData(), there->GetPointData(), "point array");
  ExpectSameArrays(one->GetFieldData(), shuffled->GetFieldData(), "field array");
}

/// Recovers a mesh as it is and shuffled.
void ExpectSameInAnyOrder(vtkPolyData* mesh, bool flips = false)
{
  std::vector<vtkIdType> place;
  const auto shuffled = Shuffled(mesh, place);
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetAllowEdgeFlips(flips);
  const auto here = Execute(filter, mesh);
  EXPECT_FALSE(SameBytes(here->GetPoints()->GetData(), mesh->GetPoints()->GetData()));
  ExpectSameButForOrder(here, Execute(filter, shuffled), place);
}
}

TEST(InvarianceOfOrder, ToTheBitOfAllThatTheRobustMethodRecovers)
{
  ExpectSameInAnyOrder(DoubleContour(BracketSolid()));
  ExpectSameInAnyOrder(Contour(BracketSolid(), 24)); // in single precision
  ExpectSameInAnyOrder(DoubleContour(BracketSolid()), true);
  ExpectSameInAnyOrder(SurfaceNet(TwoSlabs().Materials(), CleanCells).Make());
}

TEST(InvarianceOfOrder, OfTheClassification)
{
  const auto mesh = DoubleContour(BracketSolid());
  std::vector<vtkIdType> place;
  const auto shuffled = Shuffled(mesh, place);
  vtkNew<vtkUSSODFilter> filter;
  filter->SetWindow(0.05); // the average edge is a sum whose rounding depends on the order
  const auto here = Execute(filter, mesh);
  const auto there = Execute(filter, shuffled);
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    EXPECT_NEAR(here->GetPointData()->GetArray("USSOD")->GetComponent(v, 0),
      there->GetPointData()->GetArray("USSOD")->GetComponent(place[v], 0), 1e-9);
    EXPECT_EQ(here->GetPointData()->GetArray("SharpRegion")->GetComponent(v, 0),
      there->GetPointData()->GetArray("SharpRegion")->GetComponent(place[v], 0));
  }
}

TEST(InvarianceOfOrder, OfTheMovesThatFollowARegionsThinning)
{
  // Thinning breaks ties by number, so its rounds are given to both.
  const auto mesh = RecoverByPaper(DoubleContour(BracketSolid()));
  std::vector<vtkIdType> place;
  const auto shuffled = Shuffled(mesh, place);
  vtkNew<vtkSharpeningFilter> filter;
  const auto here = Execute(filter, mesh);
  const auto there = Execute(filter, shuffled);
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    Point3 a, b;
    here->GetPoint(v, a.data());
    there->GetPoint(place[v], b.data());
    EXPECT_LE((a - b).norm(), Rounding);
  }
}

TEST(InvarianceOfOrder, OfTheFeatures)
{
  const auto mesh = RecoverByPaper(DoubleContour(BoxSolid()));
  mesh->GetPointData()
    ->Initialize(); // as those of the shuffled mesh are, but the extractor uses them
  std::vector<vtkIdType> place;
  const auto shuffled = Shuffled(mesh, place);
  const auto lengthOf = [](vtkPolyData* input)
  {
    vtkNew<vtkSharpEdgeExtractor> filter;
    const auto curves = Execute(filter, input);
    double length = 0.0;
    for (vtkIdType cell = 0; cell < curves->GetNumberOfCells(); ++cell)
    {
      length += curves->GetCellData()->GetArray("Length")->GetComponent(cell, 0);
    }
    return std::make_tuple(length, curves->GetNumberOfPoints(), curves->GetNumberOfCells(),
      filter->GetCorners()->GetNumberOfPoints(),
      filter->GetSurfaces()->GetCellData()->GetArray("SurfaceId")->GetRange()[1]);
  };
  const auto here = lengthOf(mesh);
  const auto there = lengthOf(shuffled);
  EXPECT_NEAR(std::get<0>(here), std::get<0>(there), 1e-9);
  EXPECT_EQ(std::get<1>(here), std::get<1>(there)) << "points of curves";
  EXPECT_EQ(std::get<2>(here), std::get<2>(there)) << "curves";
  EXPECT_EQ(std::get<3>(here), std::get<3>(there)) << "corners";
  EXPECT_EQ(std::get<4>(here), std::get<4>(there)) << "surfaces";
}
