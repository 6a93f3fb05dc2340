#!/usr/bin/env python3
"""Recovers assemblies whose truth is known by several methods and prints how well. See the README."""

import argparse
import csv
import hashlib
import re
import sys
import tempfile
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk

import cache
import methods
from assemblies import ASSEMBLIES
from assembly_score import score
from bed import ROOT
from heldout_assemblies import HELD_OUT
from meshes import Mesh, read_mesh, to_polydata, write_polydata

EVERY = {**ASSEMBLIES, **HELD_OUT}
COLUMNS = {
    "recall": "recall %", "precision": "precision %", "false_length": "false, cells",
    "junction_recall": "junctions: recall %", "junction_precision": "precision %",
    "corners": "corners %", "free_off": "free boundary off, cells", "e_mean": "E_mean %",
    "e_max": "E_max %", "gaps": "gaps", "topology": "topology kept", "seconds": "seconds",
}


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--assemblies", nargs="+", default=list(ASSEMBLIES), metavar="NAME",
                        choices=list(EVERY), help=f"of {', '.join(ASSEMBLIES)} (the default), and, "
                        f"held out, {', '.join(HELD_OUT)}")
    parser.add_argument("--samplings", default="contour64",
                        help="with commas between: contour or nets (of assemblies of materials), "
                        "followed by the cells a side of the cube from -32 to 32 "
                        "(default: %(default)s)")
    parser.add_argument("--methods", default="input,paper,robust", help="default: %(default)s")
    parser.add_argument("--arris", type=Path, default=ROOT / "build/bin/arris")
    parser.add_argument("--cache", type=Path, default=cache.default_folder(),
                        help="where sampled meshes are kept (default: %(default)s)")
    parser.add_argument("--keep", type=Path, help="a folder for the meshes")
    parser.add_argument("--csv", help="writes every figure")
    options = parser.parse_args()
    rows = []
    for name in options.assemblies:
        truth = EVERY[name]()
        for sampling in options.samplings.split(","):
            rows += measured(name, truth, sampling, options)
    print("| | " + " | ".join(COLUMNS.values()) + " |\n" + "|---" * (len(COLUMNS) + 1) + "|")
    for row in rows:
        cells = [f"{row[key]:.4g}" if not np.isnan(row[key]) else "–" for key in COLUMNS]
        print(f"| {row['assembly']} {row['sampling']} {row['method']} | "
              + " | ".join(cells) + " |")
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, ["assembly", "sampling", "method", *COLUMNS])
            writer.writeheader()
            writer.writerows(rows)
    return 0


def measured(name, truth, sampling, options):
    """The rows of one assembly in one sampling."""
    kind, resolution = re.fullmatch("([a-z]+)([0-9]+)", sampling).groups()
    resolution = int(resolution)
    before, ids = sampled(name, truth, kind, resolution, options.cache)
    rows = []
    for method in options.methods.split(","):
        after, seconds = recovered(before, ids, method, options, f"{name}-{sampling}")
        rows.append({"assembly": name, "sampling": sampling, "method": method,
                     **score(truth, before, after, 64 / resolution), "seconds": seconds})
    return rows


def sampled(name, truth, kind, resolution, folder):
    """The sampled mesh and its patch ids, kept in the folder."""
    file = folder / "assemblies" / f"{name}-{kind}{resolution}.npz"
    key = hashlib.sha256(truth.mesh.points.tobytes() + truth.points.tobytes()).hexdigest()
    if file.exists():
        kept = np.load(file)
        if str(kept["key"]) == f"{cache.VERSION} {key}":
            return Mesh(kept["points"], kept["tris"]), kept["ids"] if len(kept["ids"]) else None
    mesh, ids = truth.sampled(kind, resolution)
    file.parent.mkdir(parents=True, exist_ok=True)
    np.savez(file, points=mesh.points, tris=mesh.tris, ids=() if ids is None else ids,
             key=f"{cache.VERSION} {key}")
    return mesh, ids


def recovered(before, ids, method, options, title):
    """The mesh that a method makes of another, and the seconds it takes."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "in.vtk", Path(folder) / "out.vtk"
        if options.keep:
            options.keep.mkdir(parents=True, exist_ok=True)
            source = options.keep / f"{title}.vtk"
            target = options.keep / f"{title}-{method}.vtk"
        polydata = to_polydata(before.points, before.tris)
        if ids is not None:
            array = numpy_to_vtk(ids.astype(np.int32), deep=True)
            array.SetName("PatchId")
            polydata.GetCellData().AddArray(array)
        write_polydata(source, polydata)
        if method == "input":
            return before, 0.0
        seconds = methods.timed([options.arris, "sharpen", source, "-o", target, "--method", method,
                                 "--quiet"])
        return read_mesh(target), seconds


if __name__ == "__main__":
    sys.exit(main())
