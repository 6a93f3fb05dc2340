# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Draws the pictures of the robust method's steps in method.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a python3 Documentation/draw_steps.py

What the steps know of each vertex and triangle is in the arrays of the recovered mesh; they are drawn
on the contour as it came, except for the last pictures.
"""

import argparse
import sys
from pathlib import Path

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from arris import vtkSharpEdgeExtractor, vtkSharpEdgeReconstruction
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

sys.path.append(str(Path(__file__).resolve().parents[1] / "Testing" / "Accuracy"))
from sampling import sampled_solid, zero_contour  # noqa: E402

SAMPLES = 32  # along each side of the grid
SIZE = (440, 360)  # pixels
GREY = (0.82, 0.83, 0.86)
RED = (0.80, 0.16, 0.14)
FACES = [(0.93, 0.79, 0.46), (0.55, 0.73, 0.90), (0.66, 0.84, 0.58), (0.90, 0.62, 0.58),
         (0.76, 0.67, 0.88), (0.60, 0.84, 0.82), (0.92, 0.72, 0.84), (0.80, 0.80, 0.55)]
OUTCOMES = [GREY, (0.25, 0.55, 0.85), (0.40, 0.72, 0.40), RED, RED, (0.95, 0.70, 0.15), GREY]


class Block:
    """A block with one roof-like side and a bore, off the axes of the grid."""

    def distance(self, points):
        x, y, z = points.T
        a, b = np.radians((17, 11))
        x, y = np.cos(a) * x + np.sin(a) * y, np.cos(a) * y - np.sin(a) * x
        y, z = np.cos(b) * y + np.sin(b) * z, np.cos(b) * z - np.sin(b) * y
        block = np.maximum(np.maximum(abs(x) - 0.62, abs(y) - 0.5), abs(z) - 0.45)
        roof = 0.94 * z + 0.34 * y - 0.38  # 20 degrees off the top
        bore = 0.2 - np.hypot(x - 0.08, z + 0.115)
        return np.maximum(np.maximum(block, roof), bore)


def table(colours):
    lookup = vtkLookupTable()
    lookup.SetNumberOfTableValues(len(colours))
    for i, colour in enumerate(colours):
        lookup.SetTableValue(i, *colour, 1)
    lookup.SetTableRange(-0.5, len(colours) - 0.5)
    return lookup


def ramp():
    steps = np.linspace(0, 1, 64)[:, None]
    return table([tuple((1 - t) * np.array(GREY) + t * np.array(RED)) for t in steps[:, 0]])


def actor_of(mesh, values=None, on_cells=False, lookup=None, scale=None):
    mapper = vtkPolyDataMapper()
    shown = vtkPolyData()
    shown.ShallowCopy(mesh)
    if values is None:
        mapper.ScalarVisibilityOff()
    else:
        array = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True)
        (shown.GetCellData() if on_cells else shown.GetPointData()).SetScalars(array)
        mapper.SetLookupTable(lookup)
        mapper.SetScalarRange(*(scale or lookup.GetTableRange()))
        mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SetInputData(shown)
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(GREY)
    look.SetInterpolationToFlat()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.35, 0.36, 0.4)
    look.SetAmbient(0.25)
    look.SetDiffuse(0.75)
    return actor


def balls(points, radius):
    cloud = vtkPolyData()
    cloud.SetPoints(vtkPoints())
    cloud.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    vertices = vtkCellArray()
    for i in range(len(points)):
        vertices.InsertNextCell(1, (i,))
    cloud.SetVerts(vertices)
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(16)
    ball.SetPhiResolution(12)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(cloud)
    glyphs.SetSourceConnection(ball.GetOutputPort())
    glyphs.ScalingOff()
    glyphs.Update()
    actor = actor_of(glyphs.GetOutput())
    actor.GetProperty().SetColor(RED)
    actor.GetProperty().EdgeVisibilityOff()
    actor.GetProperty().SetInterpolationToGouraud()
    return actor


def draw(path, *actors):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(1.6, 4.0, 2.6)
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(0.74)
    renderer.ResetCameraClippingRange()
    window.Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    print(f"wrote {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path,
                        default=Path(__file__).resolve().parent / "images")
    folder = parser.parse_args().output
    before = zero_contour(sampled_solid(Block(), SAMPLES)[0])
    recovery = vtkSharpEdgeReconstruction()
    recovery.SetInputData(before)
    extractor = vtkSharpEdgeExtractor()
    extractor.SetInputConnection(recovery.GetOutputPort())
    extractor.Update()
    after = recovery.GetOutput()

    def known(name):
        return vtk_to_numpy(after.GetPointData().GetArray(name))

    region = known("SharpRegion") > 0
    surfaces = vtk_to_numpy(extractor.GetSurfaces().GetCellData().GetArray("SurfaceId"))
    faces = table(FACES[: surfaces.max() + 1] if surfaces.max() < len(FACES) else FACES)
    skeleton = known("SkeletonRole") > 0
    draw(folder / "step-0-contour.png", actor_of(before))
    draw(folder / "step-1-turn.png",
         actor_of(before, np.clip(known("EdgeAngle"), 0, 90), lookup=ramp(), scale=(0, 90)))
    draw(folder / "step-2-region.png", actor_of(before, region, lookup=table([GREY, RED])))
    draw(folder / "step-5-faces.png", actor_of(before, surfaces, True, faces))
    draw(folder / "step-6-skeleton.png", actor_of(before),
         balls(vtk_to_numpy(before.GetPoints().GetData())[skeleton], 0.017))
    draw(folder / "step-7-positions.png", actor_of(after, surfaces, True, faces))
    draw(folder / "step-9-outcome.png", actor_of(after, known("Outcome"), lookup=table(OUTCOMES)))


if __name__ == "__main__":
    main()
