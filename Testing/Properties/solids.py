# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Random solids, joined and cut from a few primitives, and meshes sampled from them by VTK.

A solid is a function that is negative inside. It is put together from smooth ones, one for each face,
by minima and maxima, so the normals that its faces have near any point are known.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkQuadricDecimation

SAMPLINGS = ("contour", "jittered", "decimated", "blurred", "segmented", "noisy")
# On request, so that the numbers of the meshes above stay theirs: a blur of any width that leaves edges to be
# found, and noise on top, as in CT.
BLURRED_SAMPLINGS = ("softened", "scanned")
BLUR_WIDTHS = (0.3, 2.0)  # in cells
NOISE = {"noisy": 0.1, "scanned": 0.05}  # in cells


class Solid:
    """A tree of joins and cuts over smooth faces."""

    def __init__(self, value, faces):
        self.value = value
        self.faces = faces  # functions that are negative inside

    def __or__(self, other):
        return Solid(lambda p: np.minimum(self.value(p), other.value(p)), self.faces + other.faces)

    def __and__(self, other):
        return Solid(lambda p: np.maximum(self.value(p), other.value(p)), self.faces + other.faces)

    def __invert__(self):
        return Solid(lambda p: -self.value(p), [lambda p, f=f: -f(p) for f in self.faces])


def face(function):
    return Solid(function, [function])


def plane(normal, distance):
    return face(lambda p: p @ normal - distance)


def sphere(radius):
    return face(lambda p: np.linalg.norm(p, axis=-1) - radius)


def tube(radius):
    return face(lambda p: np.hypot(p[..., 0], p[..., 1]) - radius)


def funnel(slope):
    """An endless cone that opens downward from the origin."""
    along = np.array([1.0, slope]) / np.hypot(1.0, slope)
    return face(lambda p: np.hypot(p[..., 0], p[..., 1]) * along[0] + p[..., 2] * along[1])


def ring(large, small):
    return face(
        lambda p: np.hypot(np.hypot(p[..., 0], p[..., 1]) - large, p[..., 2]) - small
    )


def slab(solid, height):
    up = np.array([0.0, 0.0, 1.0])
    return solid & plane(up, height / 2) & plane(-up, height / 2)


def prism(sides, radius, height):
    around = 2 * np.pi * np.arange(sides) / sides
    solid = None
    for a in around:
        side = plane(np.array([np.cos(a), np.sin(a), 0.0]), radius)
        solid = side if solid is None else solid & side
    return slab(solid, height)


def turned(solid, rotation, offset):
    def moved(function):
        return lambda p: function((p - offset) @ rotation)

    return Solid(moved(solid.value), [moved(f) for f in solid.faces])


def random_rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def random_primitive(rng, size):
    a, b = size * rng.uniform(0.6, 1.0, 2)
    kind = rng.integers(6)
    if kind == 0:
        solid = slab(prism(4, a, 2 * b), 2 * b)
    elif kind == 1:
        solid = slab(tube(a), 2 * b)
    elif kind == 2:
        solid = sphere(a)
    elif kind == 3:
        solid = funnel(rng.uniform(0.4, 1.2)) & plane(np.array([0.0, 0.0, -1.0]), a)
        solid = turned(solid, np.eye(3), np.array([0.0, 0.0, a / 2]))
    elif kind == 4:
        solid = prism(int(rng.choice([3, 5, 6])), 0.7 * a, 2 * b)
    else:
        solid = ring(0.7 * a, 0.35 * b)
    return turned(solid, random_rotation(rng), rng.uniform(-0.3, 0.3, 3))


def random_solid(rng):
    solid = random_primitive(rng, 0.7)
    for _ in range(rng.integers(0, 4)):
        piece = random_primitive(rng, rng.uniform(0.3, 0.6))
        solid = solid | piece if rng.random() < 0.5 else solid & ~piece
    # Nothing reaches the border of the grid: the meshes are closed.
    return solid & sphere(0.95)


def polydata(points, triangles):
    """A mesh of double or single precision, as the points are."""
    positions = vtkPoints()
    positions.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    cells = vtkCellArray()
    flat = np.ascontiguousarray(triangles, dtype=np.int64).ravel()
    cells.SetData(3, numpy_to_vtkIdTypeArray(flat, deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(positions)
    mesh.SetPolys(cells)
    return mesh


def points_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())


def triangles_of(mesh):
    return vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def _blurred(values, sigma):
    reach = min(int(np.ceil(3 * sigma)), (len(values) - 1) // 2)
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    weights /= weights.sum()
    for axis in range(3):
        values = np.apply_along_axis(np.convolve, axis, values, weights, mode="same")
    return values


def _contour(values, axis, offset):
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetOrigin(offset + axis[0])
    image.SetSpacing([axis[1] - axis[0]] * 3)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    edges = vtkFlyingEdges3D()
    edges.SetInputData(image)
    edges.SetValue(0, 0.0)
    edges.ComputeNormalsOff()
    edges.ComputeScalarsOff()
    edges.Update()
    return edges.GetOutput()


def _normals(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    across = np.cross(b - a, c - a)
    normals = np.zeros_like(points)
    for k in range(3):
        np.add.at(normals, triangles[:, k], across)
    return normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]


def sample(rng, solid, sampling, samples):
    """A mesh of a solid and the width of its cells; nothing where the solid is empty."""
    cell = 2.0 / (samples - 1)
    axis = np.linspace(-1.0, 1.0, samples)
    offset = rng.uniform(-0.5, 0.5, 3) * cell
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    values = -solid.value(np.stack([x, y, z], axis=-1) + offset)
    if sampling == "blurred":
        values = _blurred(values, 0.8)
    elif sampling in BLURRED_SAMPLINGS:
        values = _blurred(values, rng.uniform(*BLUR_WIDTHS))
    elif sampling == "segmented":
        values = np.where(values > 0, 0.5, -0.5)
    mesh = _contour(values, axis, offset)
    if mesh.GetNumberOfPolys() == 0:
        return None, cell
    if sampling == "decimated":
        decimation = vtkQuadricDecimation()
        decimation.SetTargetReduction(rng.uniform(0.2, 0.6))
        decimation.SetInputData(mesh)
        decimation.Update()
        mesh = decimation.GetOutput()
    points, triangles = points_of(mesh).astype(np.float64), triangles_of(mesh)
    normals = _normals(points, triangles)
    if sampling == "jittered":
        moves = rng.uniform(-0.2, 0.2, points.shape) * cell
        points = points + moves - (moves * normals).sum(axis=1)[:, None] * normals
    elif sampling in NOISE:
        points = points + rng.normal(0.0, NOISE[sampling] * cell, len(points))[:, None] * normals
    if rng.random() < 0.5:
        points = points.astype(np.float32)
    return polydata(points, triangles), cell


def against_all_faces(solid, points, triangles, reach):
    """Which triangles face against every face of the solid that is near their middle."""
    corners = points[triangles].astype(np.float64)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middles = corners.mean(axis=1)
    any_near = np.zeros(len(triangles), dtype=bool)
    with_one = np.zeros(len(triangles), dtype=bool)
    step = 1e-6
    for f in solid.faces:
        near = np.abs(f(middles)) < reach
        p = middles[near]
        slope = np.stack([f(p + d) - f(p - d) for d in step * np.eye(3)], axis=1)
        any_near |= near
        with_one[near] |= (slope * normals[near]).sum(axis=1) >= 0
    return any_near & ~with_one
