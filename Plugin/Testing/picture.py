# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The preview as ParaView draws it with the colour maps and the legends that the plugin brings:
compared with a baseline.

    picture.py BASELINE.png
"""

import os
import sys

import session
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

# A pixel differs if a colour does by more than LARGEST of 255. Fonts, lines and silhouettes differ a
# little between machines; a preview with another angle (55 instead of 41.4) differs in 3.5 % of the
# pixels.
LARGEST = 60
SHARE = 0.01


def draw(file):
    preview = simple.SharpEdgePreview(Input=session.contour())
    view = simple.CreateRenderView(ViewSize=[640, 480])
    view.OrientationAxesVisibility = 0
    for port, name, place in ((0, "NormalDeviation", "Lower Right Corner"),
                              (1, "SkeletonRole", "Upper Right Corner")):
        shown = simple.Show(simple.OutputPort(preview, port), view)
        association = "POINTS" if port == 0 else "CELLS"
        simple.ColorBy(shown, (association, name))
        shown.SetScalarBarVisibility(view, True)
        bar = simple.GetScalarBar(simple.GetColorTransferFunction(name), view)
        bar.WindowLocation = place
    view.CameraPosition = [160.0, 220.0, 170.0]
    view.CameraFocalPoint = [15.0, 27.0, 50.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    view.CameraParallelProjection = 1
    simple.SaveScreenshot(file, view, ImageResolution=[640, 480],
                          OverrideColorPalette="WhiteBackground")


def read(file):
    assert os.path.isfile(file), f"there is no {file}"
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    colours = vtk_to_numpy(image.GetPointData().GetScalars())
    return colours.reshape(-1, colours.shape[-1])[:, :3].astype(int)


def difference(file, baseline):
    """The share of the pixels that differ."""
    return float((abs(read(file) - read(baseline)).max(axis=1) > LARGEST).mean())


def check_colours():
    """Presets are the plugin's, not ParaView's default."""
    deviation = simple.GetColorTransferFunction("NormalDeviation")
    colours = [list(deviation.RGBPoints[i + 1:i + 4]) for i in (0, 20)]
    assert colours == [[0.85, 0.87, 0.9], [0.3, 0.0, 0.12]], colours
    roles = simple.GetColorTransferFunction("SkeletonRole")
    assert list(roles.Annotations)[1::2] == ["outline", "branch", "joint", "end"]


session.load()
draw("preview.png")
check_colours()
error = difference("preview.png", sys.argv[1])
assert error < SHARE, f"{100 * error:.2f} % of preview.png differ from {sys.argv[1]}"
print(f"like the baseline but for {100 * error:.2f} % of the pixels")
