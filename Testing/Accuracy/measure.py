#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Recovers contours of exact solids by both methods and prints a table (Markdown).

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Testing/Accuracy/measure.py 64 128
"""

import sys

from arris import vtkSharpEdgeReconstruction
from part import Bracket
from sampling import sampled_solid, zero_contour
from score import score
from solids import SOLIDS


def cases(samples):
    """Name, truth, contour and cell width of everything measured at about samples^3."""
    for name, solid in SOLIDS.items():
        volume, cell = sampled_solid(solid, samples)
        yield name, solid, zero_contour(volume), cell
    if samples in (64, 128):
        stride = 128 // samples
        bracket = Bracket(stride)
        yield "Data/ bracket", bracket, zero_contour(bracket.volume), float(stride)


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
        for name, solid, mesh, cell in cases(samples):
            for method, number in methods.items():
                s = score(solid, mesh, recovered(mesh, number), cell)
                ratio = s["distance before"] / s["distance after"]
                print(f"| {name} | {samples}³ | {s['triangles']:,} | {method} | {s['recall']:.1f} % "
                      f"| {s['precision']:.1f} % | {s['distance before']:.4f} → "
                      f"{s['distance after']:.4f} | {ratio:.1f}× | {s['intact moved']} |",
                      flush=True)


if __name__ == "__main__":
    main()
