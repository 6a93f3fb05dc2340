#!/usr/bin/env python3
"""Sharp curves of recovered meshes by Arris, VTK, CGAL and libigl, on the same meshes in one run:
recall, precision, length and number against the truth, and the time on a million triangles."""

import argparse
import sys
import tempfile
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader

import cache
import cases
import finders
import methods
import sampling
from bed import ROOT
from meshes import write_mesh
from score import NEAR, curve_figures

ANGLE = 20.0  # degrees, as of the truth's sharp edges; Arris' own default is 30
MILLION = 1000000  # triangles
REPEATS = 9


def main():
    """The command line."""
    options = _options()
    tasks = [(solid, options) for solid in options.solids]
    with get_context("spawn").Pool(options.jobs) as pool:
        rows = [row for more in pool.imap(_measured, tasks) for row in more]
    _print_means(rows)
    if options.each:
        _print_each(rows)
    if options.time:
        _print_times(options)
    return 0


def _options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--solids", nargs="+", default=["designed"], metavar="NAME",
                        help="as for bed.py (default: designed)")
    parser.add_argument("--sampling", default="contour64", help="default: %(default)s")
    parser.add_argument("--arris", type=Path, default=ROOT / "build/bin/arris",
                        help="the program (default: %(default)s)")
    parser.add_argument("--cgal", type=Path, metavar="PROGRAM",
                        help="cgal_edges.cxx, compiled; without it CGAL is left out")
    parser.add_argument("--cache", type=Path, default=cache.default_folder(),
                        help="where sampled meshes are kept (default: %(default)s)")
    parser.add_argument("--each", action="store_true", help="also prints every solid")
    parser.add_argument("--time", metavar="NAME",
                        help="also prints the time on this recovered solid, its triangles cut in "
                        "four until there are a million")
    parser.add_argument("--jobs", type=int, default=2, help="default: %(default)s")
    options = parser.parse_args()
    try:
        options.solids = cases.names_of(options.solids)
        sampling.parse(options.sampling)
    except ValueError as error:
        parser.error(str(error))
    return options


def _recovered(options, solid):
    """The recovered mesh as the program writes it: with the arrays that Arris looks for."""
    with tempfile.TemporaryDirectory() as folder:
        before, after = Path(folder) / "in.vtk", Path(folder) / "out.vtk"
        write_mesh(before, cases.input_mesh(options.cache, solid, options.sampling))
        methods.run([options.arris, "sharpen", before, "-o", after, "--quiet"])
        reader = vtkPolyDataReader()
        reader.SetFileName(str(after))
        reader.Update()
        return reader.GetOutput()


def _finders(options):
    """Those that are compared, by name."""
    found = {
        "Arris": lambda mesh: finders.arris(mesh, ANGLE),
        "Arris, its defaults": finders.arris,
        "VTK": lambda mesh: finders.vtk(mesh, ANGLE),
        "libigl": lambda mesh: finders.libigl(mesh, ANGLE),
    }
    if options.cgal:
        found["CGAL"] = lambda mesh: finders.cgal(options.cgal, mesh, ANGLE)
    return found


def _measured(task):
    """A row for each finder."""
    solid, options = task
    truth, mesh = cases.truth_of(solid), _recovered(options, solid)
    cell = sampling.cell_size(options.sampling)
    true_curves, true_length = (finders.count_curves(truth.mesh.points, truth.segments),
                                truth.curve_length())
    rows = []
    for name, find in _finders(options).items():
        edges, curves, _ = find(mesh)
        figures = curve_figures(truth, edges.reshape(-1, 3), np.arange(2 * len(edges))
                                .reshape(-1, 2), cell, NEAR)
        length = figures["judged_length"]
        rows.append({"solid": solid, "finder": name, "found": curves, "true": true_curves,
                     "length": 100 * length / true_length if true_length else np.nan,
                     "curves": curves / true_curves if true_curves else np.nan, **figures})
    return rows


def _print_means(rows):
    print("| finder | recall | precision | length / true | length within 2 % | curves / true "
          "| curves right |")
    print("|---|---|---|---|---|---|---|")
    for name in dict.fromkeys(row["finder"] for row in rows):
        mine = [row for row in rows if row["finder"] == name]
        mean = {key: np.nanmean([row[key] for row in mine])
                for key in ("recall", "precision", "length", "curves")}
        near = [abs(row["length"] - 100) <= 2 for row in mine if not np.isnan(row["length"])]
        right = [row["found"] == row["true"] for row in mine]
        print(f"| {name} | {mean['recall']:.1f} % | {mean['precision']:.1f} % "
              f"| {mean['length']:.1f} % | {sum(near)} of {len(near)} | {mean['curves']:.2f} "
              f"| {sum(right)} of {len(right)} |")


def _print_each(rows):
    print("\n| solid | finder | recall | precision | false, cells | length / true | curves "
          "| true |")
    print("|---|---|---|---|---|---|---|---|")
    for row in rows:
        print(f"| {row['solid']} | {row['finder']} | {row['recall']:.1f} % "
              f"| {row['precision']:.1f} % | {row['false_length']:.1f} | {row['length']:.1f} % "
              f"| {row['found']} | {row['true']} |")


def _print_times(options):
    """Medians of runs that take turns, so that what else the machine does hits all alike."""
    cut = vtkLinearSubdivisionFilter()
    cut.SetInputData(_recovered(options, options.time))
    cut.SetNumberOfSubdivisions(0)
    while cut.GetOutput().GetNumberOfPolys() < MILLION:
        cut.SetNumberOfSubdivisions(cut.GetNumberOfSubdivisions() + 1)
        cut.Update()
    mesh = cut.GetOutput()
    timed = {
        "Arris, curves and faces": lambda: finders.arris(mesh, ANGLE),
        "Arris, the faces' shapes as well": lambda: finders.arris(mesh, ANGLE, shapes=True),
        "vtkFeatureEdges": lambda: finders.vtk(mesh, ANGLE, joined=False),
        "vtkFeatureEdges and vtkStripper": lambda: finders.vtk(mesh, ANGLE),
        "igl.sharp_edges": lambda: finders.libigl(mesh, ANGLE),
    }
    seconds = {name: [] for name in timed}
    for _ in range(REPEATS):
        for name, find in timed.items():
            seconds[name].append(find().seconds)
    if options.cgal:
        for name, segmented in (("CGAL detect_sharp_edges", False),
                                ("CGAL sharp_edges_segmentation", True)):
            seconds[name] = [finders.cgal(options.cgal, mesh, ANGLE, REPEATS, segmented).seconds]
    triangles = mesh.GetNumberOfPolys()
    print(f"\n| {triangles:,} triangles | seconds | ns a triangle |")
    print("|---|---|---|")
    for name, taken in seconds.items():
        print(f"| {name} | {np.median(taken):.3f} | {1e9 * np.median(taken) / triangles:.0f} |")


if __name__ == "__main__":
    sys.exit(main())
