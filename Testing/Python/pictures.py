# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Draws a scene off screen and compares it with the picture it should give."""

import os
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (without it nothing can be drawn)
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkActor2D,
    vtkImageMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkTestingRendering import vtkTesting

SIZE = (400, 300)

# vtkTesting adds up what differs beyond a shift by a pixel; 0 on the machine that drew the
# baselines. Other drivers shade and smooth lines a little differently. The wrong pictures of
# image_detects_wrong_pictures.py are 20 to 82 off.
TOLERANCE = 10.0

PASSED = vtkTesting.PASSED


def actor(data, color=(0.75, 0.78, 0.82)):
    """Flat shaded, so that every fold shows."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    shown = vtkActor()
    shown.SetMapper(mapper)
    shown.GetProperty().SetColor(color)
    shown.GetProperty().SetInterpolationToFlat()
    return shown


def draw(actors, direction=(0.5, 0.45, 0.8), zoom=1.2):
    """A window with these actors, seen from a direction."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for shown in actors:
        renderer.AddActor(shown)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(direction)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)  # drivers differ most in these
    window.SetSize(SIZE)
    window.AddRenderer(renderer)
    window.Render()
    return window


def read(file, scale):
    """A window that shows a picture from a file."""
    reader, resize, mapper = vtkPNGReader(), vtkImageResize(), vtkImageMapper()
    reader.SetFileName(file)
    resize.SetInputConnection(reader.GetOutputPort())
    resize.SetResizeMethodToMagnificationFactors()
    resize.SetMagnificationFactors(scale, scale, 1.0)
    resize.Update()
    mapper.SetInputConnection(resize.GetOutputPort())
    mapper.SetColorWindow(255.0)
    mapper.SetColorLevel(127.5)
    shown = vtkActor2D()
    shown.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(shown)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(resize.GetOutput().GetDimensions()[:2])
    window.AddRenderer(renderer)
    window.Render()
    return window


def difference(window, baseline):
    """Whether the window shows the baseline within the tolerance, and by how much it is off."""
    testing = vtkTesting()
    testing.AddArgument("-T")
    testing.AddArgument(os.environ["ARRIS_PICTURES"])  # what was drawn stays here if it is wrong
    testing.AddArgument("-V")
    testing.AddArgument(os.path.join(os.environ["ARRIS_BASELINES"], baseline))
    testing.SetRenderWindow(window)
    result = testing.RegressionTest(TOLERANCE)
    return result == PASSED, testing.GetImageDifference()


def compare(window, baseline):
    """Ends the script: 0 if the window shows the baseline.

    `--draw FILE` writes the picture instead: look at it before it becomes a baseline.
    """
    if "--draw" in sys.argv:
        write(window, sys.argv[sys.argv.index("--draw") + 1])
        sys.exit(0)
    same, off = difference(window, baseline)
    print(f"{baseline}: {off:.2f} off, {TOLERANCE} allowed")
    sys.exit(0 if same else 1)


def write(window, file):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(file)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
