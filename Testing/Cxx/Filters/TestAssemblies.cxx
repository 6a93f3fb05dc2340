// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Assemblies.h"
#include "FilterTesting.h"

#include <vtkSMPTools.h>
#include <vtkStringArray.h>

#include <map>

using namespace arris::testing;

namespace
{
vtkSmartPointer<vtkPolyData> Slabs()
{
  const TwoSlabs slabs;
  return SurfaceNet(slabs.Materials(), CleanCells).Make();
}

/// The same with points of their own for each patch, in the order of those that they are made of.
vtkSmartPointer<vtkPolyData> Parted(vtkPolyData* mesh)
{
  vtkDataArray* ids = mesh->GetCellData()->GetArray("PatchId");
  std::map<std::pair<vtkIdType, double>, vtkIdType> pointOf;
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, corners);
    for (const vtkIdType corner : *corners)
    {
      pointOf[{ corner, ids->GetTuple1(c) }] = 0;
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (auto& [pointAndId, number] : pointOf)
  {
    number = points->InsertNextPoint(mesh->GetPoint(pointAndId.first));
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, corners);
    for (vtkIdType& corner : *corners)
    {
      corner = pointOf[{ corner, ids->GetTuple1(c) }];
    }
    cells->InsertNextCell(corners);
  }
  auto parted = vtkSmartPointer<vtkPolyData>::New();
  parted->SetPoints(points);
  parted->SetPolys(cells);
  parted->GetCellData()->AddArray(ids);
  return parted;
}

/// The positions of all corners of all triangles, in their order.
std::vector<Point> Corners(vtkPolyData* mesh)
{
  std::vector<Point> corners;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfPolys(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, ids);
    for (vtkIdType id : *ids)
    {
      corners.emplace_back(mesh->GetPoint(id));
    }
  }
  return corners;
}

/// The vertices on edges of three triangles or more.
std::set<vtkIdType> JunctionVertices(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> trianglesOn;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfPolys(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, ids);
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType a = ids->GetId(k), b = ids->GetId((k + 1) % 3);
      ++trianglesOn[{ std::min(a, b), std::max(a, b) }];
    }
  }
  std::set<vtkIdType> vertices;
  for (const auto& [edge, count] : trianglesOn)
  {
    if (count > 2)
    {
      vertices.insert({ edge.first, edge.second });
    }
  }
  return vertices;
}

vtkSmartPointer<vtkPolyData> Recovered(vtkPolyData* mesh, int method)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetMethod(method);
  return Execute(filter, mesh);
}

constexpr int BothMethods[] = { vtkSharpEdgeReconstruction::PAPER,
  vtkSharpEdgeReconstruction::ROBUST };
}

TEST(Assemblies, TheFormOfTheInputDoesNotMatter)
{
  // Shared or doubled common vertices, with ids or found where three triangles meet, in one array
  // or the other.
  const auto shared = Slabs();
  const auto noIds = Copy(shared);
  noIds->GetCellData()->RemoveArray("PatchId");
  const auto labels = Copy(noIds);
  vtkNew<vtkIntArray> pairs;
  pairs->SetName("BoundaryLabels");
  pairs->SetNumberOfComponents(2);
  for (vtkIdType c = 0; c < shared->GetNumberOfCells(); ++c)
  {
    const int pair = static_cast<int>(shared->GetCellData()->GetArray("PatchId")->GetTuple1(c));
    const bool turned = c % 2 == 0;
    pairs->InsertNextTuple2(turned ? pair % 10 : pair / 10, turned ? pair / 10 : pair % 10);
  }
  labels->GetCellData()->AddArray(pairs);
  for (const int method : BothMethods)
  {
    const std::vector<Point> expected = Corners(Recovered(shared, method));
    EXPECT_EQ(Corners(Recovered(Parted(shared), method)), expected);
    EXPECT_EQ(Corners(Recovered(noIds, method)), expected);
    EXPECT_EQ(Corners(Recovered(labels, method)), expected);
  }
}

TEST(Assemblies, CommonVerticesStayAtOnePosition)
{
  const auto mesh = Parted(Slabs());
  std::map<std::array<double, 3>, std::vector<vtkIdType>> at;
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    std::array<double, 3> p;
    mesh->GetPoint(v, p.data());
    at[p].push_back(v);
  }
  for (const int method : BothMethods)
  {
    const auto after = Recovered(mesh, method);
    vtkDataArray* points = after->GetPoints()->GetData();
    vtkIdType moved = 0;
    for (const auto& [position, vertices] : at)
    {
      for (const vtkIdType v : vertices)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          ASSERT_EQ(points->GetComponent(v, axis), points->GetComponent(vertices[0], axis));
        }
        for (const char* name : { "SharpRegion", "SkeletonRole", "ThinningRound", "USSOD" })
        {
          vtkDataArray* values = after->GetPointData()->GetArray(name);
          EXPECT_EQ(values->GetTuple1(v), values->GetTuple1(vertices[0])) << name;
        }
        moved += vertices.size() > 1 && points->GetComponent(v, 0) != position[0] ? 1 : 0;
      }
    }
    EXPECT_GT(moved, 50);
  }
}

TEST(Assemblies, JunctionsBecomeStraight)
{
  const auto mesh = Slabs();
  const TwoSlabs slabs;
  const auto farthest = [&](vtkPolyData* of)
  {
    double most = 0.0;
    for (const vtkIdType v : JunctionVertices(of))
    {
      const Point p = slabs.Local(Point(of->GetPoint(v)));
      const double off = std::hypot(p.z() - 1.0, // the plane between, and the nearest side
        std::min(std::abs(6.0 - std::abs(p.x())), std::abs(5.0 - std::abs(p.y()))));
      most = std::max(most, off);
    }
    return most;
  };
  const double cell = 20.0 / CleanCells;
  EXPECT_GT(farthest(mesh), 0.2 * cell);
  // Planes that are carried on are off by what the samples are.
  EXPECT_LT(farthest(Recovered(mesh, vtkSharpEdgeReconstruction::ROBUST)), 0.05 * cell);
}

TEST(Assemblies, RoundWallsGoOnInTheNextPatch)
{
  // A rod of two materials, one of them a disc of little more than three cells: too little to tell
  // its radius and direction by, but its wall is that of the rest. Nets round edges over two cells,
  // and no plane or cylinder is met exactly.
  constexpr double Radius = 5.0, Between = -1.5;
  constexpr int Cells = 27; // no edge of this net has four faces between the same materials
  const Eigen::Matrix3d turn = TwoSlabs().Turn;
  const auto inRod = [&](const Point& p, double low, double high)
  {
    const Point local = turn.transpose() * p;
    return std::min({ Radius - local.head<2>().norm(), local.z() - low, high - local.z() });
  };
  const auto mesh = SurfaceNet({ [&](const Point& p) { return -inRod(p, -4.0, 5.0); },
                                 [&](const Point& p) { return inRod(p, -4.0, Between); },
                                 [&](const Point& p) { return inRod(p, Between, 5.0); } },
    Cells)
                      .Make();
  // In cells, how far off one half of the junction is at most. Single vertices hang on labels that
  // could be others; 0.02 to 0.04 were measured in eight orders of the vertices, 0.06 and more
  // where the walls are fitted apart.
  const auto off = [&](vtkPolyData* of)
  {
    std::vector<double> distances;
    for (const vtkIdType v : JunctionVertices(of))
    {
      const Point p = turn.transpose() * Point(of->GetPoint(v));
      distances.push_back(std::hypot(p.z() - Between, p.head<2>().norm() - Radius) * Cells / 20.0);
    }
    std::sort(distances.begin(), distances.end());
    return distances[distances.size() / 2];
  };
  EXPECT_GT(off(mesh), 0.25);
  EXPECT_LT(off(Recovered(mesh, vtkSharpEdgeReconstruction::ROBUST)), 0.05);
}

TEST(Assemblies, CellsAreGivenBackAsTheyCame)
{
  const auto mesh = Slabs();
  vtkNew<vtkCellArray> mixed;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfPolys(); ++c)
  {
    mesh->GetPolys()->GetCellAtId(c, ids);
    if (c % 5 < 2)
    {
      std::swap(*ids->begin(), *(ids->begin() + 1));
    }
    mixed->InsertNextCell(ids);
  }
  const auto straight = Recovered(mesh, vtkSharpEdgeReconstruction::ROBUST);
  mesh->SetPolys(mixed);
  const auto after = Recovered(mesh, vtkSharpEdgeReconstruction::ROBUST);
  ExpectSameCells(after->GetPolys(), mixed, "triangles");
  EXPECT_TRUE(
    SameBytes(after->GetCellData()->GetArray("PatchId"), mesh->GetCellData()->GetArray("PatchId")));
  std::size_t apart = 0;
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    apart += (Point(after->GetPoint(v)) - Point(straight->GetPoint(v))).norm() > 1e-6 ? 1 : 0;
  }
  EXPECT_LT(apart, static_cast<std::size_t>(mesh->GetNumberOfPoints()) / 50);
}

TEST(Assemblies, TheFilterTellsWhatItFound)
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  Execute(filter, Slabs());
  EXPECT_EQ(filter->GetNumberOfPatches(), 3);
  EXPECT_GT(filter->GetNumberOfCommonVertices(), 50);
  EXPECT_EQ(filter->GetNumberOfCommonVertices(), filter->GetNumberOfJunctionEdges()); // one loop
  EXPECT_EQ(filter->GetNumberOfOpenEdges(), 0);
  EXPECT_EQ(filter->GetNumberOfOneSidedPatches(), 0);
}

TEST(Assemblies, TheStagesGiveTheSameAsAllInOne)
{
  const auto mesh = Parted(Slabs());
  vtkNew<vtkUSSODFilter> classify;
  vtkNew<vtkSharpThinningFilter> thin;
  vtkNew<vtkSharpeningFilter> sharpen;
  classify->SetInputData(mesh);
  thin->SetInputConnection(classify->GetOutputPort());
  sharpen->SetInputConnection(thin->GetOutputPort());
  sharpen->Update();
  ExpectIdentical(sharpen->GetOutput(), RecoverByPaper(mesh));
}

TEST(Assemblies, ThreadsDoNotMatter)
{
  const auto mesh = Parted(Slabs());
  for (const int method : BothMethods)
  {
    vtkSMPTools::Initialize(1);
    const auto one = Recovered(mesh, method);
    vtkSMPTools::Initialize(4);
    ExpectIdentical(one, Recovered(mesh, method));
  }
  vtkSMPTools::Initialize(0);
}

namespace
{
void ExpectOneError(vtkPolyData* input, const std::string& about, const char* name = "PatchId")
{
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetPatchArrayName(name);
  arris::testing::ExpectOneError(filter, input, about);
  EXPECT_EQ(filter->GetNumberOfPatches(), 0);
}
}

TEST(Assemblies, PatchIdsThatAreNoneAreOneError)
{
  const auto mesh = Slabs();
  mesh->GetCellData()->GetArray("PatchId")->SetName("Whose");
  ExpectOneError(mesh, "there is no cell array 'Nobody's'", "Nobody's");

  auto bad = Copy(mesh);
  AddArray<vtkIntArray>(bad->GetCellData(), 7, "PatchId", [](vtkIdType) { return 1; });
  ExpectOneError(bad, "has 7 entries for");

  bad = Copy(mesh);
  AddArray<vtkDoubleArray>(bad->GetCellData(), mesh->GetNumberOfCells(), "PatchId",
    [](vtkIdType i) { return i == 3 ? 0.5 : 1.0; });
  ExpectOneError(bad, "not whole at cell 3");

  bad = Copy(mesh);
  vtkNew<vtkStringArray> words;
  words->SetName("PatchId");
  words->SetNumberOfValues(mesh->GetNumberOfCells());
  bad->GetCellData()->AddArray(words);
  ExpectOneError(bad, "does not hold numbers");

  bad = Copy(mesh);
  vtkNew<vtkIntArray> wide;
  wide->SetName("PatchId");
  wide->SetNumberOfComponents(3);
  wide->SetNumberOfTuples(mesh->GetNumberOfCells());
  wide->FillValue(0);
  bad->GetCellData()->AddArray(wide);
  ExpectOneError(bad, "has 3 components");
}

TEST(Assemblies, TheArrayMayHaveAnyName)
{
  const auto mesh = Slabs();
  const auto expected = Corners(Recovered(mesh, vtkSharpEdgeReconstruction::ROBUST));
  mesh->GetCellData()->GetArray("PatchId")->SetName("Whose");
  vtkNew<vtkSharpEdgeReconstruction> filter;
  filter->SetPatchArrayName("Whose");
  EXPECT_EQ(Corners(Execute(filter, mesh)), expected);
}

TEST(Assemblies, CellsWithoutAnIdAreAPatchOfTheirOwn)
{
  const auto mesh = Slabs();
  vtkDataArray* ids = mesh->GetCellData()->GetArray("PatchId");
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    if (ids->GetTuple1(c) == 12) // those between the slabs
    {
      ids->SetTuple1(c, c % 2 ? -1 : -7);
    }
  }
  vtkNew<vtkSharpEdgeReconstruction> filter;
  EXPECT_EQ(Corners(Execute(filter, mesh)),
    Corners(Recovered(Slabs(), vtkSharpEdgeReconstruction::ROBUST)));
  EXPECT_EQ(filter->GetNumberOfPatches(), 3);
}

TEST(Assemblies, VerticesFartherApartThanTheToleranceAreNotCommon)
{
  const auto mesh = Parted(Slabs());
  vtkNew<vtkSharpEdgeReconstruction> filter;
  Execute(filter, mesh);
  const vtkIdType junctions = filter->GetNumberOfJunctionEdges();
  const vtkIdType points = mesh->GetNumberOfPoints();
  for (vtkIdType v = 0; v < points; ++v) // every third point off by a little
  {
    double p[3];
    mesh->GetPoint(v, p);
    p[0] += v % 3 == 0 ? 1e-3 : 0.0;
    mesh->GetPoints()->SetPoint(v, p);
  }
  mesh->Modified();
  Execute(filter, mesh);
  EXPECT_LT(filter->GetNumberOfJunctionEdges(), junctions);
  EXPECT_GT(filter->GetNumberOfOpenEdges(), 0);
  filter->SetMergeTolerance(1e-3);
  Execute(filter, mesh);
  EXPECT_EQ(filter->GetNumberOfJunctionEdges(), junctions);
  EXPECT_EQ(filter->GetNumberOfOpenEdges(), 0);
}

TEST(Assemblies, TrianglesWithoutAreaMoveWithTheOthers)
{
  const auto mesh = Parted(Slabs());
  const auto plain = Recovered(mesh, vtkSharpEdgeReconstruction::ROBUST);
  // A patch of one triangle whose corners are all one point of the junction.
  const vtkIdType common = *JunctionVertices(Slabs()).begin();
  double p[3];
  Slabs()->GetPoint(common, p);
  vtkIdType corners[3];
  for (vtkIdType& corner : corners)
  {
    corner = mesh->GetPoints()->InsertNextPoint(p);
  }
  mesh->GetPolys()->InsertNextCell(3, corners);
  mesh->GetCellData()->GetArray("PatchId")->InsertNextTuple1(99);
  const auto after = Recovered(mesh, vtkSharpEdgeReconstruction::ROBUST);
  ASSERT_EQ(after->GetNumberOfCells(), mesh->GetNumberOfCells());
  std::vector<Point> found = Corners(after);
  const Point at = found.back();
  EXPECT_EQ(at, found[found.size() - 2]);
  found.resize(found.size() - 3);
  EXPECT_EQ(found, Corners(plain));
  EXPECT_EQ(std::count(found.begin(), found.end(), at) > 2, true);
}
