# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""What vtkSharpEdgeReconstruction promises (Documentation/promises.md), checked on one mesh.

Each check gives what it found, {finding: how many or what}: nothing if the promise was kept.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from arris import vtkSharpEdgeReconstruction
from solids import points_of, polydata, random_rotation, triangles_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkSMPTools

sys.path.append(str(Path(__file__).resolve().parents[1] / "Accuracy" / "Bed"))
from crossings import crossing_pairs  # noqa: E402

METHODS = {"robust": 1, "paper": 0}
FOLDED = -np.cos(np.radians(10.0))  # between the normals of two triangles that lie on each other
THIN = 1e-6  # of its longest edge: lower triangles have no area worth the name
ROUNDING = 1e-6  # of an edge: positions that differ less are the same, but for rounding
THREADS = (("STDThread", 2), ("STDThread", 4), ("TBB", 2), ("STDThread", 3))


class Errors:
    """Collects the errors of a filter."""

    def __init__(self, filter_):
        self.texts = []
        for source in (filter_, filter_.GetExecutive()):
            source.AddObserver("ErrorEvent", lambda *_: self.texts.append("an error"))
            source.AddObserver("WarningEvent", lambda *_: None)  # keeps them from the screen


def recover(mesh, method, backend="Sequential", threads=1):
    vtkSMPTools.SetBackend(backend)
    vtkSMPTools.Initialize(threads)
    filter_ = vtkSharpEdgeReconstruction()
    errors = Errors(filter_)
    filter_.SetMethod(METHODS[method])
    filter_.SetInputData(mesh)
    filter_.Update()
    if errors.texts:
        raise ValueError("the filter reports an error")
    return filter_.GetOutput()


def arrays_of(mesh):
    arrays = {"points": points_of(mesh), "triangles": triangles_of(mesh)}
    for place in (mesh.GetPointData(), mesh.GetCellData(), mesh.GetFieldData()):
        for i in range(place.GetNumberOfArrays()):
            name = place.GetArrayName(i)
            if not name.endswith("Seconds"):
                arrays[f"{place.GetClassName()} {name}"] = vtk_to_numpy(place.GetArray(i))
    return arrays


@dataclass
class Mesh:
    """What the crossings are looked for in."""

    points: np.ndarray
    tris: np.ndarray

    def corners(self):
        return self.points[self.tris]


def edges_of(triangles):
    """Edges of exactly two triangles: those two."""
    ends = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    key = ends[:, 0] * (triangles.max() + 1) + ends[:, 1]
    order = np.argsort(key, kind="stable")
    _, first, count = np.unique(key[order], return_index=True, return_counts=True)
    first = first[count == 2]
    return order[np.stack([first, first + 1], axis=1)] // 3


def damage(points, triangles):
    """Folded edges and thin triangles, as flags that can be compared between input and output."""
    a, b, c = points[triangles].astype(np.float64).transpose(1, 0, 2)
    across = np.cross(b - a, c - a)
    twice_area = np.linalg.norm(across, axis=1)
    longest = np.sqrt(np.max([((u - v) ** 2).sum(axis=1) for u, v in ((a, b), (b, c), (c, a))], 0))
    thin = twice_area <= THIN * longest**2
    normals = across / np.maximum(twice_area, 1e-300)[:, None]
    one, two = edges_of(triangles).T
    folded = (normals[one] * normals[two]).sum(axis=1) < FOLDED
    return {"folds": folded & ~thin[one] & ~thin[two], "degenerate": thin}


def new_crossings(before, after, triangles):
    changed = np.flatnonzero((before != after).any(axis=1)[triangles].any(axis=1))
    if len(changed) == 0:
        return 0
    key = len(triangles)
    pairs = [
        crossing_pairs(Mesh(points.astype(np.float64), triangles), changed)
        for points in (before, after)
    ]
    then, now = (set((p[:, 0] * key + p[:, 1]).tolist()) if len(p) else set() for p in pairs)
    return len(now - then)


def check_kept(mesh, output):
    """Promises 1 and 2."""
    before, after = arrays_of(mesh), arrays_of(output)
    problems = {}
    for name, values in after.items():
        if values.dtype.kind == "f" and not np.isfinite(values).all():
            problems["finite"] = name
    for name, values in before.items():
        if name != "points" and not (name in after and np.array_equal(values, after[name])):
            problems["kept"] = name
    outside = after["vtkPointData SharpRegion"] == 0
    if (before["points"] != after["points"])[outside].any():
        problems["kept"] = "points outside the sharp region"
    return problems


def check_triangles(mesh, output):
    """Promise 3."""
    triangles = triangles_of(mesh)
    before, after = points_of(mesh), points_of(output)
    then, now = damage(before, triangles), damage(after, triangles)
    counts = {name: int((now[name] & ~then[name]).sum()) for name in now}
    counts["crossings"] = new_crossings(before, after, triangles)
    return {name: count for name, count in counts.items() if count}


def check_threads(mesh, output, method, threading):
    """Promise 4."""
    one, two = arrays_of(output), arrays_of(recover(mesh, method, *threading))
    if one.keys() != two.keys():
        return {"threads": "other arrays"}
    differing = [name for name in one if one[name].tobytes() != two[name].tobytes()]
    return {"threads": differing[0]} if differing else {}


def in_double(mesh):
    return polydata(points_of(mesh).astype(np.float64), triangles_of(mesh))


def mean_edge_length(mesh):
    corners = points_of(mesh)[triangles_of(mesh)]
    return np.linalg.norm(corners[:, 1] - corners[:, 0], axis=1).mean()


def check_unit(rng, mesh, method):
    """Promise 5: in a unit that is a power of two as long, which rounds no coordinate."""
    mesh = in_double(mesh)
    unit = 2.0 ** rng.integers(-30, 31)  # about 1e-9 to 1e9
    scaled = polydata(unit * points_of(mesh), triangles_of(mesh))
    here, there = (points_of(recover(m, method)) for m in (mesh, scaled))
    apart = np.linalg.norm(here - there / unit, axis=1) > ROUNDING * mean_edge_length(mesh)
    return {"unit": int(apart.sum())} if apart.any() else {}


def moved_elsewhere(rng, mesh):
    """The mesh turned, mirrored, in another unit, shifted and stored in another order."""
    points, triangles = points_of(mesh), triangles_of(mesh)
    rotation = random_rotation(rng)
    if rng.random() < 0.5:
        rotation = rotation * np.array([-1.0, 1.0, 1.0])
        triangles = triangles[:, ::-1]
    scale = 10.0 ** rng.uniform(-9, 9)
    offset = rng.uniform(-10, 10, 3) * scale

    def motion(p):
        return scale * (p @ rotation.T) + offset

    place = rng.permutation(len(points))
    shuffled = np.empty_like(points)
    shuffled[place] = motion(points)
    triangles = place[triangles][rng.permutation(len(triangles))]
    turns = rng.integers(0, 3, len(triangles))
    triangles = np.take_along_axis(triangles, (np.arange(3) + turns[:, None]) % 3, axis=1)
    return polydata(shuffled, triangles), motion, place, scale


def check_motion(rng, mesh, method):
    """Promise 5: how many vertices are elsewhere after a motion, another unit and another order.

    A decision that hangs on rounding, or on which of two equal vertices comes first, falls the other
    way now and then; so this is a figure, and not nothing.
    """
    mesh = in_double(mesh)
    moved, motion, place, scale = moved_elsewhere(rng, mesh)
    here = motion(points_of(recover(mesh, method)))
    there = points_of(recover(moved, method))[place]
    apart = np.linalg.norm(here - there, axis=1) > ROUNDING * scale * mean_edge_length(mesh)
    return {"elsewhere": int(apart.sum())} if apart.any() else {}


def with_arrays(mesh):
    """The mesh with arrays of its own, which have to come through."""
    for name, place, count in (
        ("Number", mesh.GetPointData(), mesh.GetNumberOfPoints()),
        ("Number of the cell", mesh.GetCellData(), mesh.GetNumberOfCells()),
    ):
        array = numpy_to_vtk(np.arange(count), deep=True)
        array.SetName(name)
        place.AddArray(array)
    return mesh


def check(rng, mesh, method):
    """All promises on one mesh, and the output."""
    mesh = with_arrays(mesh)
    threading = THREADS[rng.integers(len(THREADS))]
    output = recover(mesh, method)
    found = {
        **check_kept(mesh, output),
        **check_triangles(mesh, output),
        **check_threads(mesh, output, method, threading),
        **check_unit(rng, mesh, method),
        **check_motion(rng, mesh, method),
    }
    return found, output


vtkOutputWindow.GetInstance().SetDisplayModeToNever()  # errors are counted, not shown
