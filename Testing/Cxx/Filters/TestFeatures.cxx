// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkAppendPolyData.h>
#include <vtkCleanPolyData.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkTable.h>
#include <vtkTriangleFilter.h>
#include <vtkVariant.h>

#include <map>

using namespace arris::testing;

// What vtkSharpEdgeExtractor finds on solids whose features are known, given in the ways that users
// have them: sewn, as a soup, cut open, touching each other.

namespace
{
constexpr double Pi = 3.14159265358979323846;

enum Kind
{
  Convex,
  Concave,
  Boundary,
  NonManifold
};

/// A box of 3 x 2 x 1 as VTK makes it, in quadrangles that share no points across edges.
vtkSmartPointer<vtkPolyData> Box(double x = 0.0)
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(3.0);
  box->SetYLength(2.0);
  box->SetZLength(1.0);
  box->SetCenter(x, 0.0, 0.0);
  box->Update();
  return box->GetOutput();
}

vtkSmartPointer<vtkPolyData> Sewn(vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(mesh);
  clean->Update();
  return clean->GetOutput();
}

/// Triangles, each on three points of its own, moved by up to `jitter`, no two by the same.
vtkSmartPointer<vtkPolyData> Soup(vtkPolyData* mesh, double jitter = 0.0)
{
  vtkNew<vtkTriangleFilter> cut;
  cut->SetInputData(mesh);
  cut->Update();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < cut->GetOutput()->GetNumberOfPolys(); ++t)
  {
    cut->GetOutput()->GetCellPoints(t, ids);
    cells->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      Point3 p;
      cut->GetOutput()->GetPoint(ids->GetId(k), p.data());
      const double share = static_cast<double>(points->GetNumberOfPoints()) / (3.0 * 12.0);
      p += share * jitter * Point3(0.6, 0.0, 0.8);
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
  }
  auto soup = vtkSmartPointer<vtkPolyData>::New();
  soup->SetPoints(points);
  soup->SetPolys(cells);
  return soup;
}

/// Without the polygons that a test says.
template <typename IsCut>
vtkSmartPointer<vtkPolyData> Without(vtkPolyData* mesh, IsCut&& isCut)
{
  auto rest = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetCellPoints(t, ids);
    Point3 middle = Point3::Zero();
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      Point3 p;
      mesh->GetPoint(ids->GetId(k), p.data());
      middle += p / static_cast<double>(ids->GetNumberOfIds());
    }
    if (!isCut(middle))
    {
      cells->InsertNextCell(ids);
    }
  }
  rest->SetPoints(mesh->GetPoints());
  rest->SetPolys(cells);
  return rest;
}

double Value(vtkFieldData* data, const char* name, vtkIdType i, int component = 0)
{
  return data->GetArray(name)->GetComponent(i, component);
}

/// How many cells or points have each value of an array.
std::map<int, int> Counts(vtkFieldData* data, const char* name)
{
  std::map<int, int> counts;
  vtkDataArray* values = data->GetArray(name);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    ++counts[static_cast<int>(values->GetComponent(i, 0))];
  }
  return counts;
}

void ExpectBox(vtkSharpEdgeExtractor* filter)
{
  vtkPolyData* curves = filter->GetOutput();
  ASSERT_EQ(curves->GetNumberOfLines(), 12);
  std::map<int, int> lengths;
  for (vtkIdType i = 0; i < 12; ++i)
  {
    const double length = Value(curves->GetCellData(), "Length", i);
    EXPECT_NEAR(length, std::round(length), 1e-5);
    ++lengths[static_cast<int>(std::round(length))];
    EXPECT_NEAR(Value(curves->GetCellData(), "DihedralAngle", i), 90.0, 1e-3);
  }
  EXPECT_EQ(lengths, (std::map<int, int>{ { 1, 4 }, { 2, 4 }, { 3, 4 } }));
  EXPECT_EQ(Counts(curves->GetCellData(), "CurveKind"), (std::map<int, int>{ { Convex, 12 } }));
  EXPECT_EQ(Counts(curves->GetCellData(), "Closed"), (std::map<int, int>{ { 0, 12 } }));
  vtkPolyData* corners = filter->GetCorners();
  EXPECT_EQ(Counts(corners->GetPointData(), "Valence"), (std::map<int, int>{ { 3, 8 } }));
  EXPECT_EQ(Counts(corners->GetPointData(), "CornerKind"), (std::map<int, int>{ { 0, 8 } }));
  vtkTable* faces = filter->GetFaces();
  ASSERT_EQ(faces->GetNumberOfRows(), 6);
  const double areas[] = { 6.0, 6.0, 3.0, 3.0, 2.0, 2.0 };
  for (vtkIdType row = 0; row < 6; ++row)
  {
    EXPECT_NEAR(faces->GetValueByName(row, "Area").ToDouble(), areas[row], 1e-5);
    EXPECT_EQ(faces->GetValueByName(row, "BoundaryLoops").ToInt(), 1);
    EXPECT_EQ(faces->GetValueByName(row, "Primitive").ToString(), "plane");
  }
}
}

class Features : public ::testing::Test
{
protected:
  vtkNew<vtkSharpEdgeExtractor> Filter;
  vtkNew<ErrorCounter> Errors;
  void SetUp() override { this->Errors->Watch(this->Filter); }
};

TEST_F(Features, OfABox)
{
  for (const auto& box : { Box(), Sewn(Box()), Soup(Box()) })
  {
    Execute(this->Filter, box);
    ExpectBox(this->Filter);
    EXPECT_EQ(this->Errors->Count, 0);
  }
}

TEST_F(Features, OfASoupArePutTogetherWithinTheTolerance)
{
  const double diagonal = std::sqrt(14.0);
  const auto soup = Soup(Box(), 1e-3 * diagonal);
  this->Filter->SetMergeTolerance(2e-3);
  Execute(this->Filter, soup);
  vtkPolyData* surfaces = this->Filter->GetSurfaces();
  EXPECT_TRUE(SameBytes(surfaces->GetPoints()->GetData(), soup->GetPoints()->GetData()))
    << "the mesh keeps its points";
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfLines(), 12);
  EXPECT_EQ(this->Filter->GetCorners()->GetNumberOfPoints(), 8);
  EXPECT_EQ(this->Filter->GetFaces()->GetNumberOfRows(), 6);
  EXPECT_EQ(this->Errors->Count, 0);

  this->Filter->SetMergeTolerance(1e-5);
  Execute(this->Filter, soup);
  EXPECT_EQ(this->Errors->Count, 1);
  EXPECT_NE(this->Errors->Text.find("MergeTolerance"), std::string::npos) << this->Errors->Text;
  ExpectEmptyOutputs(this->Filter);
}

TEST_F(Features, OfACappedCylinder)
{
  constexpr int Segments = 48;
  constexpr double Radius = 0.7;
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(Segments);
  cylinder->SetRadius(Radius);
  cylinder->SetHeight(2.0);
  cylinder->Update();
  const auto curves = Execute(this->Filter, cylinder->GetOutput());
  ASSERT_EQ(curves->GetNumberOfLines(), 2);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(Value(curves->GetCellData(), "Length", i),
      2.0 * Segments * Radius * std::sin(Pi / Segments), 1e-5);
    EXPECT_EQ(Value(curves->GetCellData(), "Closed", i), 1.0);
    EXPECT_EQ(Value(curves->GetCellData(), "LeftSurfaceId", i), 0.0);
    EXPECT_EQ(curves->GetLines()->GetCellSize(i), Segments + 1);
  }
  EXPECT_EQ(curves->GetNumberOfPoints(), 2 * Segments);
  EXPECT_EQ(this->Filter->GetCorners()->GetNumberOfPoints(), 0);
  vtkTable* faces = this->Filter->GetFaces();
  ASSERT_EQ(faces->GetNumberOfRows(), 3);
  EXPECT_EQ(faces->GetValueByName(0, "Primitive").ToString(), "cylinder");
  EXPECT_NEAR(faces->GetValueByName(0, "Radius").ToDouble(), Radius, 1e-6);
  EXPECT_EQ(faces->GetValueByName(0, "BoundaryLoops").ToInt(), 2);
  EXPECT_EQ(faces->GetValueByName(1, "Primitive").ToString(), "plane");
  EXPECT_EQ(faces->GetValueByName(2, "Primitive").ToString(), "plane");
}

TEST_F(Features, OfAConeAreItsRimAndItsTip)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(64);
  cone->SetRadius(1.0);
  cone->SetHeight(2.0);
  cone->Update();
  const auto curves = Execute(this->Filter, cone->GetOutput());
  EXPECT_EQ(curves->GetNumberOfLines(), 1);
  vtkPolyData* corners = this->Filter->GetCorners();
  ASSERT_EQ(corners->GetNumberOfPoints(), 1);
  EXPECT_EQ(Value(corners->GetPointData(), "Tip", 0), 1.0);
  EXPECT_EQ(Value(corners->GetPointData(), "Valence", 0), 0.0);
  EXPECT_NEAR(corners->GetPoint(0)[0], 1.0, 1e-6) << "half its height before its centre";
  vtkTable* faces = this->Filter->GetFaces();
  ASSERT_EQ(faces->GetNumberOfRows(), 2);
  EXPECT_EQ(faces->GetValueByName(0, "Primitive").ToString(), "cone");
  EXPECT_NEAR(faces->GetValueByName(0, "HalfAngle").ToDouble(), std::atan(0.5) * 180.0 / Pi, 1e-2);
}

TEST_F(Features, OfHalfABoxGoAroundItsOpening)
{
  const auto open =
    Without(Sewn(Box()), [](const Point3& middle) { return middle.z() > 0.4; }); // no lid
  const auto curves = Execute(this->Filter, open);
  EXPECT_EQ(Counts(curves->GetCellData(), "CurveKind"),
    (std::map<int, int>{ { Convex, 8 }, { Boundary, 4 } }));
  EXPECT_EQ(this->Filter->GetCorners()->GetNumberOfPoints(), 8);
  EXPECT_EQ(this->Filter->GetFaces()->GetNumberOfRows(), 5);
  for (vtkIdType i = 0; i < curves->GetNumberOfCells(); ++i)
  {
    const bool boundary = Value(curves->GetCellData(), "CurveKind", i) == Boundary;
    EXPECT_EQ(Value(curves->GetCellData(), "RightSurfaceId", i) == -1.0, boundary);
    EXPECT_EQ(Value(curves->GetCellData(), "DihedralAngle", i) == 0.0, boundary);
  }
  this->Filter->BoundaryEdgesOff();
  EXPECT_EQ(Execute(this->Filter, open)->GetNumberOfLines(), 8);
}

TEST_F(Features, OfTwoBoxesThatShareAnEdge)
{
  // The second one is above and beside the first: they meet in one edge of length 2.
  vtkNew<vtkCubeSource> other;
  other->SetXLength(3.0);
  other->SetYLength(2.0);
  other->SetZLength(1.0);
  other->SetCenter(3.0, 0.0, 1.0);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Box());
  both->AddInputConnection(other->GetOutputPort());
  both->Update();
  const auto curves = Execute(this->Filter, Sewn(both->GetOutput()));
  EXPECT_EQ(Counts(curves->GetCellData(), "CurveKind"),
    (std::map<int, int>{ { Convex, 22 }, { NonManifold, 1 } }));
  EXPECT_EQ(this->Filter->GetCorners()->GetNumberOfPoints(), 14);
  EXPECT_EQ(this->Filter->GetFaces()->GetNumberOfRows(), 12);
}

TEST_F(Features, OfTwoBoxesApartAreTwiceThoseOfOne)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Box());
  both->AddInputData(Box(10.0));
  both->Update();
  EXPECT_EQ(Execute(this->Filter, both->GetOutput())->GetNumberOfLines(), 24);
  EXPECT_EQ(this->Filter->GetCorners()->GetNumberOfPoints(), 16);
  EXPECT_EQ(this->Filter->GetFaces()->GetNumberOfRows(), 12);
}

TEST_F(Features, EveryCurveHasPointsOfItsOwnThatKnowTheMeshs)
{
  const auto box = Sewn(Box());
  const auto curves = Execute(this->Filter, box);
  EXPECT_EQ(curves->GetNumberOfPoints(), 24);
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(Value(curves->GetPointData(), "MeshPointId", i));
    Point3 here, there, tangent;
    curves->GetPoint(i, here.data());
    box->GetPoint(id, there.data());
    EXPECT_EQ(here, there);
    curves->GetPointData()->GetArray("Tangent")->GetTuple(i, tangent.data());
    EXPECT_DOUBLE_EQ(tangent.cwiseAbs().maxCoeff(), 1.0) << "along an axis";
  }
}

TEST_F(Features, AreResampledIfAsked)
{
  const auto box = Sewn(Box());
  AddArray<vtkDoubleArray>(box->GetPointData(), box->GetNumberOfPoints(), "X",
    [&](vtkIdType i) { return box->GetPoint(i)[0]; });
  this->Filter->SetResampleStep(0.1);
  const auto curves = Execute(this->Filter, box);
  EXPECT_EQ(curves->GetNumberOfPoints(), 4 * (31 + 21 + 11));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfCells(); ++cell)
  {
    curves->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      Point3 a, b;
      curves->GetPoint(ids->GetId(i), a.data());
      curves->GetPoint(ids->GetId(i + 1), b.data());
      EXPECT_NEAR((b - a).norm(), 0.1, 1e-5);
      EXPECT_NEAR(Value(curves->GetPointData(), "X", ids->GetId(i)), a.x(), 1e-6);
    }
  }
  EXPECT_EQ(Value(curves->GetCellData(), "Length", 0),
    Value(Execute(vtkSmartPointer<vtkSharpEdgeExtractor>::New(), box)->GetCellData(), "Length", 0));
}

TEST_F(Features, OfARecoveredMeshUseItsSkeleton)
{
  // A fold of 20 degrees between two strips, whose middle points the recovery has put there.
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const double slope = std::tan(10.0 * Pi / 180.0);
  for (int j = 0; j <= 10; ++j)
  {
    for (int i = -3; i <= 3; ++i)
    {
      points->InsertNextPoint(i, j, -slope * std::abs(i));
    }
  }
  for (vtkIdType j = 0; j < 10; ++j)
  {
    for (vtkIdType i = 0; i < 6; ++i)
    {
      const vtkIdType a = 7 * j + i;
      const vtkIdType quad[] = { a, a + 1, a + 8, a + 7 };
      cells->InsertNextCell(4, quad);
    }
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  this->Filter->BoundaryEdgesOff();
  EXPECT_EQ(Execute(this->Filter, mesh)->GetNumberOfLines(), 0);
  AddArray<vtkUnsignedCharArray>(
    mesh->GetPointData(), 77, "SkeletonRole", [](vtkIdType i) { return i % 7 == 3 ? 1 : 0; });
  const auto curves = Execute(this->Filter, mesh);
  ASSERT_EQ(curves->GetNumberOfLines(), 1);
  EXPECT_DOUBLE_EQ(Value(curves->GetCellData(), "Length", 0), 10.0);
}

TEST_F(Features, TheTableHasNoShapesUnlessAsked)
{
  this->Filter->FitPrimitivesOff();
  Execute(this->Filter, Box());
  EXPECT_NE(this->Filter->GetFaces()->GetColumnByName("Area"), nullptr);
  EXPECT_EQ(this->Filter->GetFaces()->GetColumnByName("Primitive"), nullptr);
}
