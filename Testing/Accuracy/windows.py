#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Compares the two window searches on the bracket of Data/: time, and how well they classify.

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Testing/Accuracy/windows.py
"""

import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from arris import vtkUSSODFilter
from part import Bracket, distances_to
from sampling import zero_contour

CELL = 1.0     # mm, of bracket.mha
DAMAGED = 0.5  # cells from a true edge within which a vertex ought to be found
INTACT = 2.0   # cells from every true edge beyond which it ought not
RUNS = 5


def main():
    bracket = Bracket(stride=1)
    mesh = zero_contour(bracket.volume)
    distance = distances_to(bracket.lines, vtk_to_numpy(mesh.GetPoints().GetData()))
    damaged, intact = distance < DAMAGED * CELL, distance > INTACT * CELL
    print(f"{mesh.GetNumberOfPolys():,} triangles, {damaged.sum():,} vertices within {DAMAGED} cell "
          f"of a true edge, {intact.sum():,} beyond {INTACT}")
    print("| window | λ/L̄ | seconds (median of 5) | found of the damaged | taken of the intact |")
    print("|---|---|---|---|---|")
    for ratio in (0.5, 0.75, 1.0, 1.5):
        for name, search in (("connected", vtkUSSODFilter.CONNECTED),
                             ("spatial", vtkUSSODFilter.SPATIAL)):
            seconds = []
            for _ in range(RUNS):
                classify = vtkUSSODFilter()
                classify.SetInputData(mesh)
                classify.SetWindowRatio(ratio)
                classify.SetWindowSearch(search)
                start = time.perf_counter()
                classify.Update()
                seconds.append(time.perf_counter() - start)
            sharp = vtk_to_numpy(
                classify.GetOutput().GetPointData().GetArray("SharpRegion")) != 0
            print(f"| {name} | {ratio} | {np.median(seconds):.3f} | "
                  f"{100 * sharp[damaged].mean():.2f} % | {100 * sharp[intact].mean():.3f} % |",
                  flush=True)


if __name__ == "__main__":
    main()
