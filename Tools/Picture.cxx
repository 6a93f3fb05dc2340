// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Picture.h"

#include "AtomicFile.h"
#include "ErrorCapture.h"
#include "Failure.h"
#include "InputFile.h"

#include "Support/Arrays.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkLightKit.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace arris
{
namespace
{
constexpr int SceneWidth = 1000;
constexpr int SceneHeight = 900;

using Colour = std::array<double, 3>;
constexpr Colour Steel = { 0.76, 0.79, 0.83 };
constexpr Colour Ink = { 0.13, 0.16, 0.20 };
constexpr Colour CurveRed = { 0.80, 0.16, 0.12 };
constexpr Colour CornerBlue = { 0.06, 0.22, 0.55 };
constexpr Colour Paper = { 1.0, 1.0, 1.0 };
constexpr Colour Sky = { 0.87, 0.90, 0.94 };

vtkSmartPointer<vtkActor> ActorOf(vtkPolyData* data, const Colour& colour)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(colour[0], colour[1], colour[2]);
  property->SetInterpolationToFlat();
  return actor;
}

/// Colours that are told from each other, and from the mesh: of the first curve, the next ...
constexpr Colour CurvePalette[] = { { 0.84, 0.15, 0.16 }, { 0.12, 0.38, 0.78 },
  { 0.95, 0.50, 0.05 }, { 0.15, 0.55, 0.20 }, { 0.55, 0.25, 0.70 }, { 0.00, 0.60, 0.65 },
  { 0.85, 0.30, 0.60 }, { 0.50, 0.33, 0.20 }, { 0.70, 0.65, 0.05 } };

/// Of convex corners, concave ones, saddles, and those without folded edges.
constexpr Colour CornerPalette[] = { { 0.05, 0.05, 0.10 }, { 1.0, 1.0, 1.0 }, { 1.0, 0.85, 0.0 },
  { 0.45, 0.45, 0.50 } };

/// Colours cells or points by a number they have.
template <std::size_t Count>
void ColourByNumber(
  vtkActor* actor, const char* array, bool ofCells, const Colour (&palette)[Count])
{
  vtkMapper* mapper = actor->GetMapper();
  auto* data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  vtkDataArray* numbers =
    ofCells ? data->GetCellData()->GetArray(array) : data->GetPointData()->GetArray(array);
  if (numbers == nullptr || numbers->GetNumberOfTuples() == 0)
  {
    return;
  }
  const double largest = std::max(1.0, numbers->GetRange()[1]);
  vtkNew<vtkLookupTable> colours;
  colours->SetNumberOfTableValues(static_cast<vtkIdType>(largest) + 1);
  colours->SetTableRange(0.0, largest);
  for (vtkIdType i = 0; i < colours->GetNumberOfTableValues(); ++i)
  {
    const Colour& colour = palette[i % Count];
    colours->SetTableValue(i, colour[0], colour[1], colour[2]);
  }
  mapper->ScalarVisibilityOn();
  mapper->SetColorModeToMapScalars(); // else bytes are taken for colours
  ofCells ? mapper->SetScalarModeToUseCellFieldData() : mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(array);
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
}

/// Lines and points lie in the surface; they are to win over it.
void DrawInFront(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -6.0);
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-12.0);
  actor->GetProperty()->LightingOff();
}

void Fill(vtkRenderer* renderer, const Scene& scene)
{
  renderer->SetBackground(Paper[0], Paper[1], Paper[2]);
  renderer->SetBackground2(Sky[0], Sky[1], Sky[2]);
  renderer->GradientBackgroundOn();
  renderer->AddActor(ActorOf(scene.Mesh, Steel));
  if (scene.Curves != nullptr)
  {
    const auto curves = ActorOf(scene.Curves, CurveRed);
    curves->GetProperty()->SetLineWidth(scene.ByNumber ? 5.0F : 3.0F);
    if (scene.ByNumber)
    {
      ColourByNumber(curves, array::CurveId, true, CurvePalette);
    }
    DrawInFront(curves);
    renderer->AddActor(curves);
  }
  if (scene.Corners != nullptr)
  {
    const auto corners = ActorOf(scene.Corners, CornerBlue);
    corners->GetProperty()->SetPointSize(scene.ByNumber ? 12.0F : 8.0F);
    if (scene.ByNumber)
    {
      ColourByNumber(corners, array::CornerKind, false, CornerPalette);
    }
    corners->GetProperty()->RenderPointsAsSpheresOn();
    DrawInFront(corners);
    renderer->AddActor(corners);
  }
  vtkNew<vtkTextActor> title;
  title->SetInput(scene.Title.c_str());
  title->GetTextProperty()->SetFontSize(26);
  title->GetTextProperty()->SetColor(Ink[0], Ink[1], Ink[2]);
  title->GetTextProperty()->SetVerticalJustificationToTop();
  title->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  title->SetPosition(0.03, 0.97);
  renderer->AddActor2D(title);
}

/// The eye's directions: to the right, up, and from the mesh to the eye.
Eigen::Matrix3d Axes(const View& view)
{
  const Eigen::Vector3d from = Eigen::Vector3d(view.From.data()).normalized();
  Eigen::Matrix3d axes;
  axes.row(0) = Eigen::Vector3d(view.Up.data()).cross(from).normalized();
  axes.row(2) = from;
  axes.row(1) = from.cross(Eigen::Vector3d(axes.row(0)));
  return axes;
}

/// The box around a mesh along the eye's directions.
Eigen::AlignedBox3d BoxOf(vtkPolyData* mesh, const Eigen::Matrix3d& axes)
{
  Eigen::AlignedBox3d box;
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    Eigen::Vector3d point;
    mesh->GetPoint(v, point.data());
    box.extend(Eigen::Vector3d(axes * point));
  }
  return box;
}

void Aim(vtkRenderer* renderer, const Scene& scene)
{
  constexpr double Margin = 1.08;
  constexpr double Aspect = double(SceneWidth) / SceneHeight;
  const View& view = scene.Eye;
  const Eigen::Matrix3d axes = Axes(view);
  const Eigen::AlignedBox3d box = BoxOf(scene.Mesh, axes);
  const Eigen::Vector3d size = box.sizes();
  const double height = Margin * std::max(size[1], size[0] / Aspect);
  const Eigen::Vector3d shift(
    (view.Middle[0] - 0.5) * height * Aspect, (view.Middle[1] - 0.5) * height, 0.0);
  const Eigen::Vector3d middle = axes.transpose() * (box.center() + shift);
  const Eigen::Vector3d eye = middle + box.diagonal().norm() * axes.row(2).transpose();

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(view.Up.data());
  camera->SetParallelScale(0.5 * height * view.Extent);
  renderer->ResetCameraClippingRange();
}
}

void CheckPictureOutput(const std::string& path)
{
  if (Extension(path) != ".png")
  {
    throw Failure(path, "is not a picture format that Arris writes", "use .png");
  }
  CheckWritable(path);
}

void DrawPicture(const std::string& path, const std::vector<Scene>& scenes, int columns)
{
  const ErrorCapture capture;
  const int count = static_cast<int>(scenes.size());
  const int rows = (count + columns - 1) / columns;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(SceneWidth * columns, SceneHeight * rows);
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightAngle(40.0, 25.0);
  lights->SetKeyToFillRatio(2.2);
  lights->SetKeyToHeadRatio(2.6);
  for (int i = 0; i < count; ++i)
  {
    const int column = i % columns;
    const int row = rows - 1 - i / columns;
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(double(column) / columns, double(row) / rows,
      double(column + 1) / columns, double(row + 1) / rows);
    Fill(renderer, scenes[i]);
    lights->AddLightsToRenderer(renderer);
    window->AddRenderer(renderer);
    Aim(renderer, scenes[i]);
  }
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  image->Update();
  WriteAtomically(path,
    [&](const std::string& scratch)
    {
      vtkNew<vtkPNGWriter> writer;
      writer->SetFileName(scratch.c_str());
      writer->SetInputConnection(image->GetOutputPort());
      writer->Write();
      const std::string cause = capture.FirstError();
      if (!cause.empty() || writer->GetErrorCode() != 0)
      {
        throw Failure(path, "cannot be drawn: " + (cause.empty() ? "the writer failed" : cause),
          "check the display and its OpenGL");
      }
    });
}
}
