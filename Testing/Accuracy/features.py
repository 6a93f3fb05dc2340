#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Curves of recovered contours by vtkSharpEdgeExtractor and by vtkFeatureEdges with vtkStripper, on
the same meshes in one run (Markdown): recall, precision, length and number against the truth, time.

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Testing/Accuracy/features.py 64
"""

import sys
import time

import numpy as np
from arris import vtkSharpEdgeExtractor, vtkSharpEdgeReconstruction
from sampling import sampled_solid, zero_contour
from score import share_near
from solids import SOLIDS
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkStripper

ANGLE = 30.0  # degrees, for both


def segments(lines):
    """The edges of polylines, n x 2 x 3."""
    points = vtk_to_numpy(lines.GetPoints().GetData()).astype(float)
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
    offsets = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    pairs = [np.stack([points[ids[a:b - 1]], points[ids[a + 1:b]]], axis=1)
             for a, b in zip(offsets[:-1], offsets[1:])]
    return np.concatenate(pairs) if pairs else np.zeros((0, 2, 3))


def length(edges):
    return np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).sum()


def timed(*pipeline):
    """The last filter's output, and the seconds that they took from the first on."""
    start = time.perf_counter()
    pipeline[-1].Update()
    return pipeline[-1].GetOutput(), time.perf_counter() - start


def by_arris(mesh):
    extract = vtkSharpEdgeExtractor()
    extract.SetFeatureAngle(ANGLE)
    extract.FitPrimitivesOff()
    extract.SetInputData(mesh)
    return timed(extract)


def by_vtk(mesh):
    edges, join = vtkFeatureEdges(), vtkStripper()
    edges.SetFeatureAngle(ANGLE)
    edges.ColoringOff()
    edges.SetInputData(mesh)
    join.SetInputConnection(edges.GetOutputPort())
    join.SetMaximumLength(1000000)
    return timed(edges, join)


def main():
    print("| solid | samples | method | recall | precision | length | curves | true | seconds |")
    print("|---|---|---|---|---|---|---|---|---|")
    for samples in [int(argument) for argument in sys.argv[1:]] or [64]:
        for name, solid in SOLIDS.items():
            volume, cell = sampled_solid(solid, samples)
            recover = vtkSharpEdgeReconstruction()
            recover.SetInputData(zero_contour(volume))
            recover.Update()
            curves = solid.curves()
            truth = np.concatenate([np.stack([c[:-1], c[1:]], axis=1) for c in curves])
            for method, find in (("arris", by_arris), ("VTK", by_vtk)):
                lines, seconds = find(recover.GetOutput())
                found = segments(lines)
                print(f"| {name} | {samples}³ | {method} "
                      f"| {100 * share_near(truth, found, cell):.1f} % "
                      f"| {100 * share_near(found, truth, cell):.1f} % "
                      f"| {100 * length(found) / length(truth):.1f} % "
                      f"| {lines.GetNumberOfLines()} | {len(curves)} | {seconds:.3f} |", flush=True)


if __name__ == "__main__":
    main()
