// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterTesting.h"

using namespace arris::testing;

// Whatever is wrong is said once, in words, and gives empty output.

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

void AddCell(vtkCellArray* cells, const std::vector<vtkIdType>& ids)
{
  cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
}
}

class Errors : public EachFilter
{
protected:
  const vtkSmartPointer<vtkPolyData> Input = Copy(ReadyMesh(16));
};

TEST_P(Errors, PointsThatAreNotFinite)
{
  for (const double bad : { NotANumber, Infinite, -Infinite })
  {
    const auto input = Copy(this->Input);
    input->GetPoints()->SetPoint(17, 0.0, bad, 0.0);
    ExpectOneError(GetParam().New(), input, "point 17");
  }
}

TEST_P(Errors, CellsThatNameAMissingPoint)
{
  for (const vtkIdType bad : { vtkIdType(-1), this->Input->GetNumberOfPoints() })
  {
    const auto input = Copy(this->Input);
    AddCell(input->GetPolys(), { 0, 1, bad });
    ExpectOneError(GetParam().New(), input, "names point " + std::to_string(bad));
  }
}

TEST_P(Errors, CellsWithoutAnyPoint)
{
  vtkNew<vtkPolyData> input;
  vtkNew<vtkCellArray> triangles;
  AddCell(triangles, { 0, 1, 2 });
  input->SetPolys(triangles);
  AddQuietArrays(input);
  ExpectOneError(this->Filter, input, "names point 0, but there are 0 points");
}

TEST_P(Errors, PointsTooFarAway)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto input = Copy(this->Input);
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    points->DeepCopy(input->GetPoints());
    points->SetPoint(17, 0.0, type == VTK_FLOAT ? 2e36 : 2e50, 0.0);
    input->SetPoints(points);
    ExpectOneError(GetParam().New(), input,
      type == VTK_FLOAT ? "point 17 is too far away: no coordinate may be larger than 1e+36"
                        : "point 17 is too far away: no coordinate may be larger than 1e+50");
  }
}

TEST_P(Errors, AMeshOfEdgesTooShortToReckonWith)
{
  const auto input = Copy(this->Input);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(input->GetNumberOfPoints());
  for (vtkIdType v = 0; v < input->GetNumberOfPoints(); ++v)
  {
    Point3 p;
    input->GetPoint(v, p.data());
    points->SetPoint(v, (1e-60 * p).eval().data());
  }
  input->SetPoints(points);
  ExpectOneError(this->Filter, input, "the mesh is too small");
}

TEST_P(Errors, StripsThatNameAMissingPoint)
{
  vtkNew<vtkCellArray> strips;
  AddCell(strips, { 0, 1, 2, 1000000 });
  this->Input->SetStrips(strips);
  ExpectOneError(this->Filter, this->Input, "triangle strip");
}

TEST_P(Errors, PolygonsOfTwoPoints)
{
  AddCell(this->Input->GetPolys(), { 0, 1 });
  ExpectOneError(this->Filter, this->Input, "has 2 points");
}

TEST_P(Errors, StripsOfTwoPoints)
{
  vtkNew<vtkCellArray> strips;
  AddCell(strips, { 0, 1 });
  this->Input->SetStrips(strips);
  ExpectOneError(this->Filter, this->Input, "has 2 points");
}

TEST_P(Errors, PolygonsThatCannotBeCut)
{
  const vtkIdType first = this->Input->GetNumberOfPoints();
  const auto input = Copy(this->Input);
  for (int i = 0; i < 6; ++i) // six points in one place are no hexagon
  {
    input->GetPoints()->InsertNextPoint(2.0, 2.0, 2.0);
  }
  input->GetPointData()->Initialize();
  AddQuietArrays(input);
  AddCell(input->GetPolys(), { first, first + 1, first + 2, first + 3, first + 4, first + 5 });
  ExpectOneError(this->Filter, input, "cannot be cut into triangles");
}

TEST_P(Errors, ARepairedInputWorksAgain)
{
  const auto bad = Copy(this->Input);
  bad->GetPoints()->SetPoint(17, NotANumber, 0.0, 0.0);
  ExpectOneError(this->Filter, bad, "point 17");
  const auto repaired = Execute(this->Filter, this->Input);
  ExpectIdentical(repaired, Execute(GetParam().New(), this->Input));
  EXPECT_GT(this->MeshOutput()->GetNumberOfPoints(), 0);
}

INSTANTIATE_TEST_SUITE_P(Filters, Errors, AllFilters(), FilterName);

namespace
{
/// The parameters that USSOD and reconstruction share. Where 0 leaves them to the method, it is no
/// error.
template <typename Filter>
void ExpectWindowErrors(bool zeroIsAutomatic)
{
  const auto input = ReadyMesh(16);
  const auto expect = [&](void (*set)(Filter*, double), double value, const char* about)
  {
    vtkNew<Filter> filter;
    set(filter, value);
    ExpectOneError(filter, input, about);
  };
  for (const double bad : { -1.0, NotANumber, Infinite })
  {
    expect([](Filter* filter, double value) { filter->SetWindow(value); }, bad, "Window");
  }
  for (const double bad : { -1.0, NotANumber, Infinite, zeroIsAutomatic ? -0.5 : 0.0 })
  {
    expect([](Filter* filter, double value) { filter->SetWindowRatio(value); }, bad, "WindowRatio");
  }
}

template <typename Filter>
void ExpectClassificationErrors(bool zeroIsAutomatic)
{
  ExpectWindowErrors<Filter>(zeroIsAutomatic);
  const auto input = ReadyMesh(16);
  for (const double bad : { -5.0, 180.5, NotANumber, Infinite, zeroIsAutomatic ? -0.5 : 0.0 })
  {
    vtkNew<Filter> filter;
    filter->SetSharpAngle(bad);
    ExpectOneError(filter, input, "SharpAngle");
  }
  for (const int bad : { -1, 2 })
  {
    vtkNew<Filter> filter;
    filter->SetWindowSearch(bad);
    ExpectOneError(filter, input, "WindowSearch");
  }
}
}

TEST(ErrorsOfParameters, OfUSSOD)
{
  ExpectClassificationErrors<vtkUSSODFilter>(false);
}

TEST(ErrorsOfParameters, OfReconstruction)
{
  ExpectClassificationErrors<vtkSharpEdgeReconstruction>(true);
}

TEST(ErrorsOfParameters, OfSharpening)
{
  ExpectWindowErrors<vtkSharpeningFilter>(false);
}

TEST(ErrorsOfParameters, OfTheMethod)
{
  for (const int bad : { -1, 2 })
  {
    vtkNew<vtkSharpEdgeReconstruction> filter;
    filter->SetMethod(bad);
    ExpectOneError(filter, ReadyMesh(16), "Method");
  }
}

TEST(ErrorsOfParameters, OfTheExtractor)
{
  for (const double bad : { 0.0, -5.0, 180.5, NotANumber })
  {
    vtkNew<vtkSharpEdgeExtractor> feature;
    feature->SetFeatureAngle(bad);
    ExpectOneError(feature, ReadyMesh(16), "FeatureAngle");
    vtkNew<vtkSharpEdgeExtractor> corner;
    corner->SetCornerAngle(bad);
    ExpectOneError(corner, ReadyMesh(16), "CornerAngle");
  }
}

namespace
{
void ExpectExtractorErrors(void (*set)(vtkSharpEdgeExtractor*, double),
  const std::vector<double>& bad, const std::string& about)
{
  const auto input = ReadyMesh(16);
  for (const double value : bad)
  {
    vtkNew<vtkSharpEdgeExtractor> filter;
    set(filter, value);
    ExpectOneError(filter, input, about);
  }
}
}

TEST(ErrorsOfParameters, OfTheExtractorsSizes)
{
  using Filter = vtkSharpEdgeExtractor;
  ExpectExtractorErrors([](Filter* filter, double value) { filter->SetContinuationAngle(value); },
    { -1.0, 31.0, NotANumber }, "ContinuationAngle");
  ExpectExtractorErrors([](Filter* filter, double value) { filter->SetMaximumAngle(value); },
    { 29.0, 181.0, NotANumber }, "MaximumAngle");
  const std::vector<double> bad = { -1.0, NotANumber, Infinite };
  ExpectExtractorErrors(
    [](Filter* filter, double value) { filter->SetNoiseFactor(value); }, bad, "NoiseFactor");
  ExpectExtractorErrors(
    [](Filter* filter, double value) { filter->SetMinimumLength(value); }, bad, "MinimumLength");
  ExpectExtractorErrors(
    [](Filter* filter, double value) { filter->SetMergeTolerance(value); }, bad, "MergeTolerance");
  ExpectExtractorErrors([](Filter* filter, double value) { filter->SetResampleStep(value); },
    { -1.0, NotANumber, Infinite, 1e-9 }, "ResampleStep");
  ExpectExtractorErrors(
    [](Filter* filter, double value) { filter->SetFitTolerance(value); }, bad, "FitTolerance");
  ExpectExtractorErrors([](Filter* filter, double value) { filter->SetGapLength(value); },
    { NotANumber, Infinite }, "GapLength");
  ExpectExtractorErrors([](Filter* filter, double value) { filter->SetTailLength(value); },
    { NotANumber, Infinite }, "TailLength");
}

TEST(ErrorsOfMeshes, WithoutTriangles)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkSharpEdgeExtractor> filter;
  ExpectOneError(filter, nothing, "no triangles");
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  ExpectOneError(vtkSmartPointer<vtkSharpEdgeExtractor>::New(), cloud, "no triangles");
}

TEST(ErrorsOfParameters, AnUnusedRatioIsNotLookedAt)
{
  vtkNew<vtkUSSODFilter> filter;
  filter->SetWindow(0.1);
  filter->SetWindowRatio(-1.0);
  EXPECT_GT(Execute(filter, ReadyMesh(16))->GetNumberOfPoints(), 0);
}

TEST(ErrorsOfArrays, MissingOnes)
{
  const auto input = Contour(BracketSolid(), 16);
  vtkNew<vtkSharpThinningFilter> thinning;
  ExpectOneError(thinning, input, "SharpRegion");
  vtkNew<vtkSharpeningFilter> sharpening;
  ExpectOneError(sharpening, input, "ThinningRound");
}

TEST(ErrorsOfArrays, OfTheWrongSize)
{
  for (const char* name : { "SharpRegion", "USSOD" })
  {
    const auto input = ReadyMesh(16);
    AddArray<vtkDoubleArray>(
      input->GetPointData(), input->GetNumberOfPoints() - 1, name, [](vtkIdType) { return 1.0; });
    vtkNew<vtkSharpThinningFilter> filter;
    ExpectOneError(filter, input, name);
  }
  const auto input = ReadyMesh(16);
  AddArray<vtkIntArray>(input->GetPointData(), input->GetNumberOfPoints() + 1, "ThinningRound",
    [](vtkIdType) { return -1; });
  vtkNew<vtkSharpeningFilter> filter;
  ExpectOneError(filter, input, "ThinningRound");
}

TEST(ErrorsOfArrays, OfTheWrongNumberOfComponents)
{
  const auto input = ReadyMesh(16);
  vtkNew<vtkDoubleArray> pairs;
  pairs->SetName("SharpRegion");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(input->GetNumberOfPoints());
  pairs->Fill(0.0);
  input->GetPointData()->AddArray(pairs);
  vtkNew<vtkSharpThinningFilter> filter;
  ExpectOneError(filter, input, "SharpRegion");
}

TEST(ErrorsOfArrays, ValuesThatAreNotFinite)
{
  for (const char* name : { "SharpRegion", "USSOD" })
  {
    const auto input = ReadyMesh(16);
    AddArray<vtkDoubleArray>(input->GetPointData(), input->GetNumberOfPoints(), name,
      [](vtkIdType v) { return v == 5 ? NotANumber : 1.0; });
    vtkNew<vtkSharpThinningFilter> filter;
    ExpectOneError(filter, input, "point 5");
  }
}

TEST(ErrorsOfArrays, ThinningRoundsThatAreNone)
{
  const vtkIdType points = ReadyMesh(16)->GetNumberOfPoints();
  for (const double bad : { 0.0, -2.0, 1.5, NotANumber, 1e18, static_cast<double>(points) + 2.0 })
  {
    const auto input = ReadyMesh(16);
    AddArray<vtkDoubleArray>(input->GetPointData(), points, "ThinningRound",
      [&](vtkIdType v) { return v == 5 ? bad : -1.0; });
    vtkNew<vtkSharpeningFilter> filter;
    ExpectOneError(filter, input, "point 5");
  }
}
