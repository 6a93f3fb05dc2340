// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Assemblies.h"
#include "FilterTesting.h"

#include <vtkAppendPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>

using namespace arris::testing;

// The blocks of a composite data set are one assembly, and come out as they were arranged.

namespace
{
/// The cells of one patch with the points they use.
vtkSmartPointer<vtkPolyData> PatchOf(vtkPolyData* mesh, double id, bool keepIds)
{
  auto patch = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> pointOf(mesh->GetNumberOfPoints(), -1);
  vtkDataArray* ids = mesh->GetCellData()->GetArray("PatchId");
  vtkNew<vtkIdList> corners;
  vtkNew<vtkIntArray> own;
  own->SetName("PatchId");
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    if (ids->GetTuple1(c) != id)
    {
      continue;
    }
    mesh->GetPolys()->GetCellAtId(c, corners);
    for (vtkIdType& corner : *corners)
    {
      if (pointOf[corner] < 0)
      {
        pointOf[corner] = points->InsertNextPoint(mesh->GetPoint(corner));
      }
      corner = pointOf[corner];
    }
    cells->InsertNextCell(corners);
    own->InsertNextValue(static_cast<int>(id));
  }
  patch->SetPoints(points);
  patch->SetPolys(cells);
  if (keepIds)
  {
    patch->GetCellData()->AddArray(own);
  }
  AddArray<vtkDoubleArray>(patch->GetPointData(), points->GetNumberOfPoints(), "Own",
    [id](vtkIdType v) { return id + static_cast<double>(v); });
  return patch;
}

std::vector<vtkSmartPointer<vtkPolyData>> Patches(bool keepIds)
{
  const TwoSlabs slabs;
  const auto mesh = SurfaceNet(slabs.Materials(), CleanCells).Make();
  return { PatchOf(mesh, 1, keepIds), PatchOf(mesh, 2, keepIds), PatchOf(mesh, 12, keepIds) };
}

vtkSmartPointer<vtkPolyData> Appended()
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const auto& patch : Patches(true))
  {
    append->AddInputData(patch);
  }
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkMultiBlockDataSet> Blocks(bool keepIds)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const auto patches = Patches(keepIds);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, patches[1]);
  inner->SetBlock(2, patches[2]); // and none at 1
  blocks->SetBlock(0, patches[0]);
  blocks->SetBlock(1, inner);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  blocks->SetBlock(2, image);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "the other two");
  return blocks;
}

/// The meshes of a composite data set, in their order.
std::vector<vtkPolyData*> Meshes(vtkCompositeDataSet* data)
{
  std::vector<vtkPolyData*> meshes;
  vtkSmartPointer<vtkCompositeDataIterator> at;
  at.TakeReference(data->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    if (auto* mesh = vtkPolyData::SafeDownCast(at->GetCurrentDataObject()))
    {
      meshes.push_back(mesh);
    }
  }
  return meshes;
}

void ExpectSameAsAppended(vtkCompositeDataSet* output, int method)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetMethod(method);
  const auto whole = Execute(filter, Appended());
  vtkIdType v = 0;
  for (vtkPolyData* mesh : Meshes(output))
  {
    for (vtkIdType own = 0; own < mesh->GetNumberOfPoints(); ++own, ++v)
    {
      ASSERT_EQ(Point(mesh->GetPoint(own)), Point(whole->GetPoint(v)));
      for (const char* name : { "USSOD", "ThinningRound", "Displacement", "Own" })
      {
        ASSERT_EQ(mesh->GetPointData()->GetArray(name)->GetComponent(own, 0),
          whole->GetPointData()->GetArray(name)->GetComponent(v, 0))
          << name;
      }
    }
  }
  EXPECT_EQ(v, whole->GetNumberOfPoints());
}
}

TEST(Blocks, AreOneAssemblyAndKeepTheirStructure)
{
  for (const int method : { vtkSharpEdgeReconstruction::PAPER, vtkSharpEdgeReconstruction::ROBUST })
  {
    for (const bool keepIds : { true, false })
    {
      vtkNew<vtkSharpEdgeReconstruction> filter;
      filter->SetMethod(method);
      const auto input = Blocks(keepIds);
      filter->SetInputDataObject(input);
      filter->Update();
      auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      ASSERT_NE(output, nullptr);
      EXPECT_EQ(output->GetNumberOfBlocks(), 3u);
      EXPECT_STREQ(output->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME()), "the other two");
      auto* inner = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(1));
      ASSERT_NE(inner, nullptr);
      EXPECT_EQ(inner->GetNumberOfBlocks(), 3u);
      EXPECT_EQ(inner->GetBlock(1), nullptr);
      EXPECT_NE(vtkImageData::SafeDownCast(output->GetBlock(2)), nullptr);
      EXPECT_EQ(filter->GetNumberOfPatches(), 3);
      ExpectSameAsAppended(output, method);
    }
  }
}

TEST(Blocks, OfACollectionAreMaterialsAndPartitionsPieces)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  const auto patches = Patches(false);
  collection->SetPartition(0, 0, patches[0]);
  collection->SetPartition(1, 0, patches[1]);
  collection->SetPartition(1, 1, patches[2]);
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetInputDataObject(collection);
  filter->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetNumberOfPartitions(1), 2u);
  EXPECT_GT(filter->GetNumberOfCommonVertices(), 50);

  // The two pieces of one closed mesh are sewn.
  vtkNew<vtkPartitionedDataSet> pieces;
  const TwoSlabs slabs;
  const auto outside = [&](const Point& p) { return -TwoSlabs::InBox(slabs.Local(p), -4.0, 4.0); };
  const auto inside = [&](const Point& p) { return -outside(p); };
  const auto mesh = SurfaceNet({ outside, inside }, CleanCells).Make();
  vtkDataArray* ids = mesh->GetCellData()->GetArray("PatchId");
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    ids->SetTuple1(c, c < mesh->GetNumberOfCells() / 3 ? 1 : 2);
  }
  pieces->SetPartition(0, PatchOf(mesh, 1, false));
  pieces->SetPartition(1, PatchOf(mesh, 2, false));
  filter->SetInputDataObject(pieces);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPatches(), 1);
  EXPECT_EQ(filter->GetNumberOfOpenEdges(), 0);
}

TEST(Blocks, GoThroughAllStages)
{
  vtkNew<vtkUSSODFilter> classify;
  vtkNew<vtkSharpThinningFilter> thin;
  vtkNew<vtkSharpeningFilter> sharpen;
  classify->SetInputDataObject(Blocks(true));
  thin->SetInputConnection(classify->GetOutputPort());
  sharpen->SetInputConnection(thin->GetOutputPort());
  sharpen->Update();
  EXPECT_GT(thin->GetSkeleton()->GetNumberOfCells(), 3);
  ExpectSameAsAppended(vtkCompositeDataSet::SafeDownCast(sharpen->GetOutputDataObject(0)),
    vtkSharpEdgeReconstruction::PAPER);
}

TEST(Blocks, AreClassifiedOnceForAllAngles)
{
  vtkNew<vtkUSSODFilter> filter;
  filter->SetInputDataObject(Blocks(true));
  const auto seconds = [&]
  {
    filter->Update();
    vtkFieldData* fieldData =
      Meshes(vtkCompositeDataSet::SafeDownCast(filter->GetOutputDataObject(0)))[0]->GetFieldData();
    return fieldData->GetArray("ClassificationSeconds")->GetTuple1(0);
  };
  EXPECT_GT(seconds(), 0.0);
  filter->SetSharpAngle(50.0);
  EXPECT_EQ(seconds(), 0.0);
  filter->SetPatchArrayName("");
  EXPECT_GT(seconds(), 0.0);
}

TEST(Blocks, WithAnErrorInOneGiveNothing)
{
  const auto blocks = Blocks(true);
  Meshes(blocks)[1]->GetPoints()->SetPoint(5, 0.0, std::nan(""), 0.0);
  vtkNew<vtkSharpEdgeReconstruction> filter;
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  filter->SetInputDataObject(blocks);
  filter->Update();
  EXPECT_EQ(errors->Count, 1);
  EXPECT_NE(errors->Text.find("point 5"), std::string::npos) << errors->Text;
  EXPECT_TRUE(Meshes(vtkCompositeDataSet::SafeDownCast(filter->GetOutputDataObject(0))).empty());
}

TEST(Blocks, AMeshAfterBlocksIsAMeshAgain)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetInputDataObject(Blocks(true));
  filter->Update();
  filter->SetInputDataObject(Appended());
  filter->Update();
  ASSERT_NE(filter->GetOutput(), nullptr);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), Appended()->GetNumberOfPoints());
}
