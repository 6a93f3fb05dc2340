#!/usr/bin/env python3
"""Runs ArrisBenchmarks and prints the whole filters beside each other: medians of several runs that
take turns, as ratios to vtkWindowedSincPolyDataFilter (20 iterations) on the same mesh and threads,
and the memory at the peak as a ratio to the mesh's own."""

import argparse
import json
import statistics
import subprocess
import time
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
KINDS = {"0": "contour", "1": "irregular", "2": "shuffled"}
YARDSTICK = "vtkWindowedSincPolyDataFilter"


def main():
    """The command line."""
    options = _options()
    seconds, counters = _measure(options)
    if options.others:
        _measure_others(options)
    print("| mesh | triangles | threads | filter | ms | ns a triangle | ratio | peak / input |")
    print("|---|---|---|---|---|---|---|---|")
    for (kind, thousands, threads), filters in sorted(seconds.items()):
        unit = statistics.median(filters[YARDSTICK]) if YARDSTICK in filters else float("nan")
        for name, times in filters.items():
            count, peak = counters.get((name, kind, thousands, threads), (thousands * 1000, 0.0))
            median = statistics.median(times)
            print(f"| {KINDS[kind]} | {count:,.0f} | {threads} | {name} | {median * 1e3:.1f} | "
                  f"{median * 1e9 / count:.0f} | {median / unit:.2f} | "
                  + (f"{peak:.2f} |" if peak else "|"))


def _options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, default=ROOT / "build/bin/ArrisBenchmarks",
                        help="default: %(default)s")
    parser.add_argument("--filter", default="^vtk.*/0/1000/", metavar="REGEX",
                        help="of Google Benchmark: name/kind/thousands/threads (default: contours "
                        "of a million triangles)")
    parser.add_argument("--runs", type=int, default=7, help="default: %(default)s")
    parser.add_argument("--cpu", action="store_true", help="processor time in place of elapsed "
                        "time: for one thread on a machine that others use")
    parser.add_argument("--others", type=Path, metavar="MESH.ply", help="also times pymeshlab's "
                        "two-step smoothing and MeshLib's sharpOffsetMesh on this mesh, if their "
                        "packages are there; in milliseconds, in a line of their own")
    return parser.parse_args()


def _measure(options):
    command = [options.program, f"--benchmark_filter={options.filter}", "--benchmark_format=json",
               f"--benchmark_repetitions={options.runs}", "--benchmark_min_time=0",
               "--benchmark_enable_random_interleaving=true"]
    report = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)
    seconds = defaultdict(lambda: defaultdict(list))
    counters = {}
    for run in report["benchmarks"]:
        if run["run_type"] != "iteration" or run["name"].count("/") != 4:
            continue
        name, kind, thousands, threads = run["name"].split("/")[:4]
        elapsed = run["cpu_time" if options.cpu else "real_time"]
        seconds[kind, int(thousands), int(threads)][name].append(1e-3 * elapsed)
        if "triangles" in run:
            counters[name, kind, int(thousands), int(threads)] = (run["triangles"], run["peak"])
    return seconds, counters


def _measure_others(options):
    for label, prepare in (("pymeshlab, two-step smoothing", _two_step),
                           ("MeshLib, sharpOffsetMesh", _sharp_offset)):
        try:
            work = prepare(str(options.others))
        except ImportError as missing:
            print(f"{label}: {missing}")
            continue
        times = []
        for _ in range(options.runs):
            start = time.perf_counter()
            work()
            times.append(time.perf_counter() - start)
        print(f"{label}: {statistics.median(times) * 1e3:.0f} ms")


def _two_step(path):
    import pymeshlab

    def work():
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(original)
        meshes.apply_coord_two_steps_smoothing()
    loaded = pymeshlab.MeshSet()
    loaded.load_new_mesh(path)
    original = loaded.current_mesh()
    return work


def _sharp_offset(path):
    from meshlib import mrmeshpy

    mesh = mrmeshpy.loadMesh(path)
    parameters = mrmeshpy.SharpOffsetParameters()
    parameters.voxelSize = mesh.averageEdgeLength()
    return lambda: mrmeshpy.sharpOffsetMesh(mrmeshpy.MeshPart(mesh), 0.0, parameters)


if __name__ == "__main__":
    main()
