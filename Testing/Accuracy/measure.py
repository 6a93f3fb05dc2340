#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Recovers contours of exact solids by both methods and prints a table (Markdown).

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Testing/Accuracy/measure.py 64 128
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

from arris import vtkSharpEdgeReconstruction
from score import score
from solids import SOLIDS

WIDTH = 2.0  # of the sampled cube; the solids are about 1.5 wide


def contour(solid, samples):
    """The zero contour of the solid's distance on samples^3 points, and the width of a cell."""
    cell = WIDTH / (samples - 1)
    axis = np.linspace(-WIDTH / 2, WIDTH / 2, samples)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    values = -solid.distance(np.column_stack([x.ravel(), y.ravel(), z.ravel()]))
    image = vtkImageData()
    image.SetDimensions(samples, samples, samples)
    image.SetSpacing(cell, cell, cell)
    image.SetOrigin(-WIDTH / 2, -WIDTH / 2, -WIDTH / 2)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    edges = vtkFlyingEdges3D()
    edges.SetInputData(image)
    edges.SetValue(0, 0.0)
    edges.ComputeNormalsOff()
    edges.ComputeScalarsOff()
    edges.Update()
    return edges.GetOutput(), cell


def recovered(mesh, method):
    recovery = vtkSharpEdgeReconstruction()
    recovery.SetMethod(method)
    recovery.SetInputData(mesh)
    recovery.Update()
    return recovery.GetOutput()


def main():
    methods = {"paper": vtkSharpEdgeReconstruction.PAPER,
               "robust": vtkSharpEdgeReconstruction.ROBUST}
    print("| solid | samples | triangles | method | recall | precision | mean distance before → "
          "after (cells) | nearer by | intact moved |")
    print("|---|---|---|---|---|---|---|---|---|")
    for samples in [int(argument) for argument in sys.argv[1:]] or [64]:
        for name, solid in SOLIDS.items():
            mesh, cell = contour(solid, samples)
            for method, number in methods.items():
                s = score(solid, mesh, recovered(mesh, number), cell)
                ratio = s["distance before"] / s["distance after"]
                print(f"| {name} | {samples}³ | {s['triangles']:,} | {method} | {s['recall']:.1f} % "
                      f"| {s['precision']:.1f} % | {s['distance before']:.4f} → "
                      f"{s['distance after']:.4f} | {ratio:.1f}× | {s['intact moved']} |",
                      flush=True)


if __name__ == "__main__":
    main()
