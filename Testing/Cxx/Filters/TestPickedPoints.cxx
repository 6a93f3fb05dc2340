// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkPlaneSource.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkTrivialProducer.h>

#include <algorithm>
#include <limits>

using namespace arris::testing;

// Points picked on the contour of a box, as positions and as selections of every kind.

namespace
{
template <typename Array = vtkIdTypeArray>
vtkSmartPointer<Array> List(const std::vector<double>& values, int components = 1)
{
  auto list = vtkSmartPointer<Array>::New();
  list->SetNumberOfComponents(components);
  list->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    list->SetComponent(
      static_cast<vtkIdType>(i) / components, static_cast<int>(i) % components, values[i]);
  }
  return list;
}

vtkSmartPointer<vtkSelection> Selected(int content, int field, vtkAbstractArray* list)
{
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(content);
  node->SetFieldType(field);
  node->SetSelectionList(list);
  auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

/// Half of a frustum's width where it begins and where it ends, half of its depth, and how much of
/// x - y is left: 0 is a plane.
struct Shape
{
  double Near = 1e-3;
  double Far = 1e-3;
  double Depth = 1e-3;
  double Thickness = 1.0;
};

class PickedPoints : public ::testing::Test
{
protected:
  PickedPoints()
  {
    this->Mesh = Contour(BoxSolid(), 20);
    const auto classified = Execute(vtkSmartPointer<vtkUSSODFilter>::New(), this->Mesh);
    vtkDataArray* deviation = classified->GetPointData()->GetArray("NormalDeviation");
    vtkIdType smooth = 0;
    for (vtkIdType v = 0; v < deviation->GetNumberOfTuples(); ++v)
    {
      this->Sharp =
        deviation->GetComponent(v, 0) > deviation->GetComponent(this->Sharp, 0) ? v : this->Sharp;
      smooth = deviation->GetComponent(v, 0) < deviation->GetComponent(smooth, 0) ? v : smooth;
    }
    this->Smooth = smooth;
    AddArray<vtkIdTypeArray>(this->Mesh->GetPointData(), this->Mesh->GetNumberOfPoints(), "Label",
      [](vtkIdType v) { return 1000 + v; });
    this->Mesh->GetPointData()->SetGlobalIds(this->Mesh->GetPointData()->GetArray("Label"));
    this->Position.resize(3);
    this->Mesh->GetPoint(this->Sharp, this->Position.data());
  }

  /// By the position alone, which all kinds of selections must agree with.
  void ExpectLikeThePosition(vtkSelection* selection)
  {
    vtkNew<vtkUSSODFilter> byPosition;
    byPosition->SetPickedPointsSharp(this->At({ this->Sharp }));
    const auto expected = Execute(byPosition, this->Mesh);
    vtkNew<vtkUSSODFilter> bySelection;
    bySelection->SetPickedPointsSharpData(selection);
    const auto found = Execute(bySelection, this->Mesh);
    EXPECT_NE(byPosition->GetUsedSharpAngle(), byPosition->GetSharpAngle());
    EXPECT_EQ(bySelection->GetUsedSharpAngle(), byPosition->GetUsedSharpAngle());
    EXPECT_EQ(bySelection->GetUsedWindow(), byPosition->GetUsedWindow());
    ExpectIdentical(found, expected);
  }

  /// Around the sharpest point, as vtkSelection has it: x slowest, z fastest.
  vtkSmartPointer<vtkDoubleArray> Frustum(const Shape& shape) const
  {
    std::vector<double> corners;
    for (int corner = 0; corner < 8; ++corner)
    {
      const bool far = corner % 2 == 1;
      const double width = far ? shape.Far : shape.Near;
      const double x = corner / 4 == 0 ? -width : width;
      const double y = corner / 2 % 2 == 0 ? -width : width;
      const double off = (1.0 - shape.Thickness) * (x - y) / 2.0;
      corners.push_back(this->Position[0] + x - off);
      corners.push_back(this->Position[1] + y + off);
      corners.push_back(this->Position[2] + (far ? shape.Depth : -shape.Depth));
      corners.push_back(1.0);
    }
    return List<vtkDoubleArray>(corners, 4);
  }

  /// Picks cells at the sharpest point; of each of `cells` one point at least is sharp then.
  void ExpectSharp(vtkIdList* cells, vtkSelection* selection)
  {
    vtkNew<vtkUSSODFilter> filter;
    filter->SetPickedPointsSharpData(selection);
    const auto result = Execute(filter, this->Mesh);
    EXPECT_NE(filter->GetUsedSharpAngle(), filter->GetSharpAngle());
    vtkDataArray* region = result->GetPointData()->GetArray("SharpRegion");
    vtkNew<vtkIdList> points;
    for (const vtkIdType cell : *cells)
    {
      this->Mesh->GetCellPoints(cell, points);
      EXPECT_TRUE(std::any_of(points->begin(), points->end(),
        [region](vtkIdType v) { return region->GetComponent(v, 0) == 1.0; }))
        << cell;
    }
  }

  vtkSmartPointer<vtkPoints> At(const std::vector<vtkIdType>& ids) const
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    for (const vtkIdType id : ids)
    {
      points->InsertNextPoint(this->Mesh->GetPoint(id));
    }
    return points;
  }

  void ExpectError(vtkSharpRegionAlgorithm* filter, const std::string& about) const
  {
    vtkNew<ErrorCounter> errors;
    errors->Watch(filter);
    filter->SetInputData(this->Mesh);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(errors->Count, 1) << about;
    EXPECT_NE(errors->Text.find(about), std::string::npos) << errors->Text;
    ExpectEmptyOutputs(filter);
  }

  vtkSmartPointer<vtkPolyData> Mesh;
  vtkIdType Sharp = 0;
  vtkIdType Smooth = 0;
  std::vector<double> Position;
};
}

TEST_F(PickedPoints, AreClassifiedAsPicked)
{
  vtkNew<vtkUSSODFilter> filter;
  filter->SetPickedPointsSharp(this->At({ this->Sharp }));
  filter->SetPickedPointsSmooth(this->At({ this->Smooth }));
  const auto result = Execute(filter, this->Mesh);
  vtkDataArray* region = result->GetPointData()->GetArray("SharpRegion");
  EXPECT_EQ(region->GetComponent(this->Sharp, 0), 1.0);
  EXPECT_EQ(region->GetComponent(this->Smooth, 0), 0.0);

  // What was chosen is told, and the same numbers given by hand do the same.
  EXPECT_EQ(
    result->GetFieldData()->GetArray("Lambda")->GetComponent(0, 0), filter->GetUsedWindow());
  EXPECT_EQ(result->GetFieldData()->GetArray("SharpAngle")->GetComponent(0, 0),
    filter->GetUsedSharpAngle());
  EXPECT_NEAR(filter->GetUsedWindowRatio() *
      result->GetFieldData()->GetArray("AverageEdgeLength")->GetComponent(0, 0),
    filter->GetUsedWindow(), 1e-12);
  vtkNew<vtkUSSODFilter> byHand;
  byHand->SetWindow(filter->GetUsedWindow());
  byHand->SetSharpAngle(filter->GetUsedSharpAngle());
  ExpectIdentical(Execute(byHand, this->Mesh), result);
}

TEST_F(PickedPoints, SteerBothMethods)
{
  for (const int method : { vtkSharpEdgeReconstruction::PAPER, vtkSharpEdgeReconstruction::ROBUST })
  {
    vtkNew<vtkSharpEdgeReconstruction> picked;
    picked->SetMethod(method);
    const auto automatic = Execute(picked, this->Mesh);
    const double angle = picked->GetUsedSharpAngle();
    picked->SetPickedPointsSharp(this->At({ this->Sharp }));
    const auto result = Execute(picked, this->Mesh);
    EXPECT_NE(picked->GetUsedSharpAngle(), angle);
    vtkNew<vtkSharpEdgeReconstruction> byHand;
    byHand->SetMethod(method);
    byHand->SetWindow(picked->GetUsedWindow());
    byHand->SetSharpAngle(picked->GetUsedSharpAngle());
    ExpectIdentical(Execute(byHand, this->Mesh), result);
    picked->SetPickedPointsSharp(nullptr);
    ExpectIdentical(Execute(picked, this->Mesh), automatic);
  }
}

TEST_F(PickedPoints, ByIndex)
{
  const auto id = static_cast<double>(this->Sharp);
  this->ExpectLikeThePosition(
    Selected(vtkSelectionNode::INDICES, vtkSelectionNode::POINT, List({ id })));
}

TEST_F(PickedPoints, ByGlobalIdAndByValue)
{
  const auto list = List({ 1000.0 + static_cast<double>(this->Sharp) });
  this->ExpectLikeThePosition(Selected(vtkSelectionNode::GLOBALIDS, vtkSelectionNode::POINT, list));
  list->SetName("Label");
  this->ExpectLikeThePosition(Selected(vtkSelectionNode::VALUES, vtkSelectionNode::POINT, list));
}

TEST_F(PickedPoints, ByThreshold)
{
  const double label = 1000.0 + static_cast<double>(this->Sharp);
  const auto list = List<vtkDoubleArray>({ label - 0.5, label + 0.5 });
  list->SetName("Label");
  this->ExpectLikeThePosition(
    Selected(vtkSelectionNode::THRESHOLDS, vtkSelectionNode::POINT, list));
}

TEST_F(PickedPoints, ByThresholdOfAComponent)
{
  vtkNew<vtkIntArray> pairs; // 0 and the point's number
  pairs->SetName("Pairs");
  pairs->SetNumberOfComponents(2);
  for (int v = 0; v < this->Mesh->GetNumberOfPoints(); ++v)
  {
    pairs->InsertNextTuple2(0.0, v);
  }
  this->Mesh->GetPointData()->AddArray(pairs);
  const auto number = static_cast<double>(this->Sharp);
  const auto list = List<vtkDoubleArray>({ number, number });
  list->SetName("Pairs");
  const auto selection = Selected(vtkSelectionNode::THRESHOLDS, vtkSelectionNode::POINT, list);
  selection->GetNode(0)->GetProperties()->Set(vtkSelectionNode::COMPONENT_NUMBER(), 1);
  this->ExpectLikeThePosition(selection);
}

TEST_F(PickedPoints, ByLocation)
{
  this->ExpectLikeThePosition(Selected(
    vtkSelectionNode::LOCATIONS, vtkSelectionNode::POINT, List<vtkDoubleArray>(this->Position, 3)));
}

TEST_F(PickedPoints, ByFrustum)
{
  for (const double nearWidth : { 1e-3, 0.0 }) // 0: a pyramid
  {
    this->ExpectLikeThePosition(Selected(
      vtkSelectionNode::FRUSTUM, vtkSelectionNode::POINT, this->Frustum({ nearWidth, 1e-3 })));
  }
}

TEST_F(PickedPoints, ByAFrustumOfNoWidthAreErrors)
{
  // In the plane x = y - as that of a rectangle drawn on a picture, where it has no width - in a
  // line, in a point, and with a corner that is no number: all would select what is far off.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkUSSODFilter> filter;
  for (const auto& shape : { Shape{ 1.0, 1.0, 1.0, 0.0 }, Shape{ 0.0, 0.0, 1.0 },
         Shape{ 0.0, 0.0, 0.0 }, Shape{ 1.0, nan, 1.0 } })
  {
    filter->SetPickedPointsSharpData(
      Selected(vtkSelectionNode::FRUSTUM, vtkSelectionNode::POINT, this->Frustum(shape)));
    this->ExpectError(filter, "its frustum has no width");
  }
  filter->SetPickedPointsSharpData(
    Selected(vtkSelectionNode::FRUSTUM, vtkSelectionNode::POINT, List<vtkDoubleArray>({ 1.0 }, 1)));
  this->ExpectError(filter, "eight corners");
}

TEST_F(PickedPoints, ByInversionAndExpression)
{
  std::vector<double> others;
  for (vtkIdType v = 0; v < this->Mesh->GetNumberOfPoints(); ++v)
  {
    if (v != this->Sharp)
    {
      others.push_back(static_cast<double>(v));
    }
  }
  auto selection = Selected(vtkSelectionNode::INDICES, vtkSelectionNode::POINT, List(others));
  selection->GetNode(0)->GetProperties()->Set(vtkSelectionNode::INVERSE(), 1);
  this->ExpectLikeThePosition(selection);

  auto both = vtkSmartPointer<vtkSelection>::New();
  const auto pair = List({ static_cast<double>(this->Sharp), static_cast<double>(this->Smooth) });
  both->SetNode(
    "pair", Selected(vtkSelectionNode::INDICES, vtkSelectionNode::POINT, pair)->GetNode(0));
  both->SetNode("other", selection->GetNode(0));
  both->SetExpression("pair & other");
  this->ExpectLikeThePosition(both);
}

TEST_F(PickedPoints, ByCell)
{
  // Of a cell's points the sharpest counts.
  vtkNew<vtkIdList> around;
  this->Mesh->BuildLinks();
  this->Mesh->GetPointCells(this->Sharp, around);
  this->ExpectSharp(
    around, Selected(vtkSelectionNode::FRUSTUM, vtkSelectionNode::CELL, this->Frustum({})));
  vtkNew<vtkIdList> one;
  one->InsertNextId(around->GetId(0));
  const auto id = static_cast<double>(one->GetId(0));
  this->ExpectSharp(one, Selected(vtkSelectionNode::INDICES, vtkSelectionNode::CELL, List({ id })));
  vtkNew<vtkIdList> points;
  this->Mesh->GetCellPoints(one->GetId(0), points);
  std::vector<double> middle(3, 0.0); // which no other cell is as near to
  for (const vtkIdType v : *points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      middle[axis] += this->Mesh->GetPoint(v)[axis] / 3.0;
    }
  }
  this->ExpectSharp(one,
    Selected(vtkSelectionNode::LOCATIONS, vtkSelectionNode::CELL, List<vtkDoubleArray>(middle, 3)));
}

TEST_F(PickedPoints, ByConnectionsUntilTheyAreRemoved)
{
  vtkNew<vtkUSSODFilter> filter;
  const auto automatic = Execute(filter, this->Mesh);
  const auto producerOf = [](vtkIdType v)
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(Selected(
      vtkSelectionNode::INDICES, vtkSelectionNode::POINT, List({ static_cast<double>(v) })));
    return vtkSmartPointer<vtkTrivialProducer>(producer);
  };
  const auto sharp = producerOf(this->Sharp);
  const auto smooth = producerOf(this->Smooth);
  filter->SetPickedPointsSharpConnection(sharp->GetOutputPort());
  filter->SetPickedPointsSmoothConnection(smooth->GetOutputPort());
  vtkNew<vtkUSSODFilter> byPosition;
  byPosition->SetPickedPointsSharp(this->At({ this->Sharp }));
  byPosition->SetPickedPointsSmooth(this->At({ this->Smooth }));
  ExpectIdentical(Execute(filter, this->Mesh), Execute(byPosition, this->Mesh));
  filter->RemovePickedPointsSharpInput();
  filter->RemovePickedPointsSmoothInput();
  ExpectIdentical(Execute(filter, this->Mesh), automatic);
}

TEST_F(PickedPoints, NoneLeaveTheParametersAsTheyAre)
{
  vtkNew<vtkUSSODFilter> plain;
  const auto expected = Execute(plain, this->Mesh);
  vtkNew<vtkUSSODFilter> filter;
  vtkNew<vtkPoints> none;
  filter->SetPickedPointsSharp(none);
  filter->SetPickedPointsSmoothData(vtkSmartPointer<vtkSelection>::New());
  ExpectIdentical(Execute(filter, this->Mesh), expected);
}

TEST_F(PickedPoints, AChangeOfThePointsRunsTheFilterAgain)
{
  vtkNew<vtkUSSODFilter> filter;
  const auto points = this->At({ this->Sharp });
  filter->SetPickedPointsSharp(points);
  Execute(filter, this->Mesh);
  const double before = filter->GetUsedSharpAngle();
  points->Reset();
  points->Modified();
  filter->Update();
  EXPECT_NE(filter->GetUsedSharpAngle(), before);
}

TEST_F(PickedPoints, ThatContradictEachOtherAreNamed)
{
  vtkNew<vtkUSSODFilter> filter;
  filter->SetPickedPointsSharpData(Selected(vtkSelectionNode::INDICES, vtkSelectionNode::POINT,
    List({ static_cast<double>(this->Smooth) })));
  filter->SetPickedPointsSmoothData(Selected(vtkSelectionNode::INDICES, vtkSelectionNode::POINT,
    List({ static_cast<double>(this->Sharp) })));
  const std::string sharp = "point " + std::to_string(this->Sharp) + ", picked as smooth";
  const std::string smooth = "point " + std::to_string(this->Smooth) + ", picked as sharp";
  this->ExpectError(filter, sharp);
  this->ExpectError(filter, smooth);
  vtkNew<vtkSharpEdgeReconstruction> whole;
  whole->SetPickedPointsSharp(this->At({ this->Smooth }));
  whole->SetPickedPointsSmooth(this->At({ this->Sharp }));
  this->ExpectError(whole, "contradict");
}

TEST_F(PickedPoints, ThatCannotBeReadAreErrors)
{
  vtkNew<vtkUSSODFilter> filter;
  filter->SetPickedPointsSharpData(
    Selected(vtkSelectionNode::INDICES, vtkSelectionNode::POINT, List({ 1e6 })));
  this->ExpectError(filter, "point 1000000");
  filter->SetPickedPointsSharpData(
    Selected(vtkSelectionNode::QUERY, vtkSelectionNode::POINT, List({ 1.0 })));
  this->ExpectError(filter, "QUERY");
  filter->SetPickedPointsSharpData(
    Selected(vtkSelectionNode::INDICES, vtkSelectionNode::FIELD, List({ 1.0 })));
  this->ExpectError(filter, "points or cells");
  const auto list = List({ 1.0 });
  list->SetName("NoSuchArray");
  filter->SetPickedPointsSharpData(
    Selected(vtkSelectionNode::VALUES, vtkSelectionNode::POINT, list));
  this->ExpectError(filter, "array");
}

TEST_F(PickedPoints, FarFromTheMeshAreErrors)
{
  vtkNew<vtkPoints> far;
  far->InsertNextPoint(7.0, 8.0, 9.0);
  vtkNew<vtkUSSODFilter> filter;
  filter->SetPickedPointsSharp(far);
  this->ExpectError(filter, "(7, 8, 9)");
}

TEST_F(PickedPoints, WhereTheSurfaceIsFlatCannotBeSharp)
{
  // A sheet of nine points has no edge anywhere.
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(8, 8);
  plane->Update();
  this->Mesh = plane->GetOutput();
  vtkNew<vtkUSSODFilter> filter;
  filter->SetPickedPointsSharp(this->At({ 40 }));
  this->ExpectError(filter, "flat");
}

namespace
{
double ClassificationSeconds(vtkPolyData* mesh)
{
  return mesh->GetFieldData()->GetArray("ClassificationSeconds")->GetComponent(0, 0);
}

/// The filter's second result must be that of a new filter with the same parameters.
template <typename Filter>
void ExpectKeptWhileOnlyTheAngleChanges(void (*prepare)(Filter*))
{
  const auto input = Contour(BracketSolid(), 24);
  vtkNew<Filter> filter;
  prepare(filter);
  EXPECT_GT(ClassificationSeconds(Execute(filter, input)), 0.0);
  filter->SetSharpAngle(30.0);
  const auto second = Execute(filter, input);
  EXPECT_EQ(ClassificationSeconds(second), 0.0);
  vtkNew<Filter> fresh;
  prepare(fresh);
  fresh->SetSharpAngle(30.0);
  ExpectIdentical(second, Execute(fresh, input));

  filter->SetWindowRatio(1.0);
  EXPECT_GT(ClassificationSeconds(Execute(filter, input)), 0.0) << "another window";
  filter->SetWindowSearchToSpatial();
  EXPECT_GT(ClassificationSeconds(Execute(filter, input)), 0.0) << "another search";
  input->GetPoints()->SetPoint(0, 0.0, 0.0, 0.0);
  input->Modified();
  EXPECT_GT(ClassificationSeconds(Execute(filter, input)), 0.0) << "another mesh";
  EXPECT_GT(ClassificationSeconds(Execute(filter, Copy(input))), 0.0) << "a copy of the mesh";
}
}

TEST(Classification, IsKeptWhileOnlyTheAngleChanges)
{
  ExpectKeptWhileOnlyTheAngleChanges<vtkUSSODFilter>([](vtkUSSODFilter*) {});
  ExpectKeptWhileOnlyTheAngleChanges<vtkSharpEdgeReconstruction>(
    [](vtkSharpEdgeReconstruction* filter) { filter->SetMethodToPaper(); });
}
