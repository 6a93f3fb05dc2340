# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Runs inside ParaView's window, for tour.sh: opens the volume, contours it, and sets the camera."""

import os

from paraview.simple import *

volume = OpenDataFile(os.environ["ARRIS_VOLUME"])
RenameSource("bracket.mha", volume)
volume.UpdatePipeline()
contour = Contour(registrationName="Contour1", Input=volume,
                  ContourBy=["POINTS", volume.PointData.keys()[0]], Isosurfaces=[0.0],
                  ComputeNormals=0, ComputeScalars=0)
view = GetActiveViewOrCreate("RenderView")
Show(contour, view)
view.CameraPosition = [160.0, 220.0, 170.0]
view.CameraFocalPoint = [15.0, 27.0, 50.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.CameraParallelProjection = 1
view.OrientationAxesVisibility = 0
ResetCamera(view)
SetActiveSource(contour)
Render()
with open("ready", "w", encoding="utf-8"):
    pass
