"""How sharp curves are found on a mesh: by Arris, VTK, CGAL and libigl, each with its own means.

A finder takes a vtkPolyData and an angle in degrees, and returns Found: edges (pairs of positions),
the number of curves, and the seconds without what it takes to hand the mesh over. CGAL and libigl
give edges alone: `count_curves` joins these, and the true ones, and is not timed.
"""

import subprocess
import tempfile
import time
from collections import namedtuple
from pathlib import Path

import igl
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkStripper

from arris import vtkSharpEdgeExtractor
from meshes import from_polydata

Found = namedtuple("Found", "edges curves seconds")
TURN = 60.0  # degrees: a curve that turns by more is two


def count_curves(points, ends):
    """How many curves edges (pairs of point ids) make that are split where other than two meet
    or where they turn by more than TURN."""
    if not len(ends):
        return 0
    valence = np.bincount(ends.ravel(), minlength=len(points))
    split = valence != 2
    outward = np.zeros((len(points), 3))  # the sum of both unit vectors is short where straight
    way = points[ends[:, 1]] - points[ends[:, 0]]
    way /= np.maximum(np.linalg.norm(way, axis=1), 1e-300)[:, None]
    np.add.at(outward, ends[:, 0], way)
    np.add.at(outward, ends[:, 1], -way)
    split |= (valence == 2) & (np.linalg.norm(outward, axis=1) > 2 * np.sin(np.radians(TURN / 2)))

    # Each edge is a node; two that meet at a point where nothing splits are joined.
    parent = np.arange(len(ends))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    first = {}
    for edge, pair in enumerate(ends):
        for point in pair[~split[pair]]:
            parent[root(edge)] = root(first.setdefault(point, edge))
    return len({root(i) for i in range(len(ends))})


def _timed(*pipeline):
    start = time.perf_counter()
    pipeline[-1].Update()
    return pipeline[-1].GetOutput(), time.perf_counter() - start


def _of_lines(lines, seconds):
    points = vtk_to_numpy(lines.GetPoints().GetData()).astype(float)
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
    offsets = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    starts = np.setdiff1d(np.arange(len(ids)), offsets[1:] - 1)
    edges = np.stack([points[ids[starts]], points[ids[starts + 1]]], axis=1) if len(ids) \
        else np.zeros((0, 2, 3))
    return Found(edges, lines.GetNumberOfLines(), seconds)


def arris(mesh, angle=None, shapes=False):
    """vtkSharpEdgeExtractor; without an angle, as it comes but for the shapes of the faces."""
    extract = vtkSharpEdgeExtractor()
    extract.SetFitPrimitives(shapes)
    if angle:
        extract.SetFeatureAngle(angle)
    extract.SetInputData(mesh)
    return _of_lines(*_timed(extract))


def vtk(mesh, angle, joined=True):
    """vtkFeatureEdges, and vtkStripper to join what it finds."""
    edges, join = vtkFeatureEdges(), vtkStripper()
    edges.SetFeatureAngle(angle)
    edges.ColoringOff()
    edges.SetInputData(mesh)
    join.SetInputConnection(edges.GetOutputPort())
    join.SetMaximumLength(1000000)
    return _of_lines(*_timed(edges, join)) if joined else _of_lines(*_timed(edges))


def libigl(mesh, angle):
    """igl.sharp_edges."""
    plain = from_polydata(mesh)
    start = time.perf_counter()
    ends = igl.sharp_edges(plain.points, plain.tris, np.radians(angle))
    seconds = time.perf_counter() - start
    return Found(plain.points[ends], count_curves(plain.points, ends), seconds)


def cgal(program, mesh, angle, repeats=1, segmented=False):
    """detect_sharp_edges, or sharp_edges_segmentation, which calls it, by cgal_edges.cxx."""
    plain = from_polydata(mesh)
    with tempfile.TemporaryDirectory() as folder:
        file, result = Path(folder) / "mesh.off", Path(folder) / "edges"
        with open(file, "w", encoding="ascii") as out:
            out.write(f"OFF\n{len(plain.points)} {len(plain.tris)} 0\n")
            np.savetxt(out, plain.points, fmt="%.17g")
            np.savetxt(out, np.insert(plain.tris, 0, 3, axis=1), fmt="%d")
        done = subprocess.run([str(program), file, str(angle), str(repeats), result], check=True,
                              capture_output=True, text=True)
        ends = np.array(result.read_text("ascii").split(), dtype=int).reshape(-1, 2)
    seconds = float(done.stdout.split()[1 if segmented else 0])
    return Found(plain.points[ends], count_curves(plain.points, ends), seconds)
