#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Checks the promises of Documentation/promises.md on random solids, sampled and turned at random.

Each mesh has a number that makes it again. Ends with a table, and with status 1 if a promise that is
to hold everywhere was broken. With --mesh, looks at one mesh for one thing, for scripts/shrink.
"""

import argparse
import sys
import time
from collections import defaultdict
from pathlib import Path

import numpy as np
import promises
import solids
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

SAMPLES = (10, 20)  # along each side of the grid
# What must be found nowhere, what is not to be found (promise 3), and what is a figure.
NEVER = ("error", "finite", "kept", "threads")
DAMAGE = ("folds", "degenerate", "crossings", "flips")
FIGURES = ("unit", "elsewhere")
FINDINGS = NEVER + DAMAGE + FIGURES


def must_hold(method, finding):
    """The paper's method was not made to keep promise 3."""
    return finding in NEVER or (finding in DAMAGE and method == "robust")


def random_mesh(number, samplings=solids.SAMPLINGS, samples=SAMPLES):
    """The solid, mesh, sampling and cell width of a number."""
    rng = np.random.default_rng(number)
    while True:
        solid = solids.random_solid(rng)
        sampling = str(rng.choice(samplings))
        mesh, cell = solids.sample(rng, solid, sampling, int(rng.integers(*samples)))
        if mesh is not None:
            return solid, mesh, sampling, cell


def flips(solid, mesh, output, cell):
    """Triangles that now, and not before, face against every face of the solid near them."""
    triangles = solids.triangles_of(mesh)
    before, after = solids.points_of(mesh), solids.points_of(output)
    changed = np.flatnonzero((before != after).any(axis=1)[triangles].any(axis=1))
    then, now = (
        solids.against_all_faces(solid, points, triangles[changed], cell)
        for points in (before, after)
    )
    return int((now & ~then).sum())


def check(number, method, solid, mesh, cell):
    """{finding: how many or what}."""
    try:
        found, output = promises.check(np.random.default_rng(number), mesh, method)
    except ValueError as error:
        return {"error": str(error)}
    flipped = flips(solid, mesh, output, cell)
    return {**found, "flips": flipped} if flipped else found


def write(mesh, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetDataModeToAscii()
    writer.SetInputData(mesh)
    writer.Write()


def look_at(path, method, finding):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    try:
        found, _ = promises.check(np.random.default_rng(0), reader.GetOutput(), method)
    except ValueError as error:
        found = {"error": str(error)}
    print(found or "nothing found")
    return 1 if finding in found or (finding is None and found) else 0


def run(options):
    meshes = defaultdict(int)  # (method, finding) -> how many meshes have it
    total = defaultdict(int)
    triangles = vertices = 0
    start = time.process_time()
    numbers = range(options.first, options.first + options.count)
    methods = options.methods.split(",")
    for number in numbers:
        solid, mesh, sampling, cell = random_mesh(
            number, options.samplings.split(","), options.samples
        )
        triangles += mesh.GetNumberOfPolys()
        vertices += mesh.GetNumberOfPoints()
        for method in methods:
            for finding, what in check(number, method, solid, mesh, cell).items():
                meshes[method, finding] += 1
                total[method, finding] += what if isinstance(what, int) else 1
                if must_hold(method, finding):
                    print(f"mesh {number} ({sampling}), {method}: {finding}: {what}", flush=True)
                    if options.keep:
                        options.keep.mkdir(parents=True, exist_ok=True)
                        write(mesh, options.keep / f"{number}-{sampling}.vtp")
    print(
        f"{len(numbers)} meshes, {triangles} triangles, {vertices} vertices,"
        f" {time.process_time() - start:.0f} s of processor time"
    )
    broken = 0
    for method in methods:
        for finding in FINDINGS:
            count = meshes[method, finding]
            print(f"{method:8}{finding:12}{count:6} meshes{total[method, finding]:8} in all")
            allowed = options.allow if finding == "flips" else 0
            broken += must_hold(method, finding) and count > allowed
    return 1 if broken else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0, help="number of the first mesh")
    parser.add_argument("--count", type=int, default=2000, help="how many meshes")
    parser.add_argument("--methods", default="robust,paper")
    parser.add_argument(
        "--samplings",
        default=",".join(solids.SAMPLINGS),
        help="to choose among; on request also " + " and ".join(solids.BLURRED_SAMPLINGS),
    )
    parser.add_argument(
        "--samples",
        type=int,
        nargs=2,
        default=SAMPLES,
        metavar=("LEAST", "LESS_THAN"),
        help="along each side of the grid",
    )
    parser.add_argument("--keep", type=Path, help="folder for the meshes that break a promise")
    parser.add_argument(
        "--allow",
        type=int,
        default=0,
        metavar="MESHES",
        help="that may have flips",
    )
    parser.add_argument("--mesh", help="look at this .vtp alone")
    parser.add_argument("--finding", choices=FINDINGS, help="what to look for in it")
    options = parser.parse_args()
    if options.mesh:
        return look_at(options.mesh, options.methods.split(",")[0], options.finding)
    return run(options)


if __name__ == "__main__":
    sys.exit(main())
