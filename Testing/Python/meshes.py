# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes for the Python tests."""

import numpy
from vtkmodules.util.numpy_support import (
    numpy_to_vtk,
    numpy_to_vtkIdTypeArray,
    vtk_to_numpy,
)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D


def box_distance(x, y, z, half):
    """The exact signed distance to a box about the origin, positive inside."""
    out = [abs(x) - half[0], abs(y) - half[1], abs(z) - half[2]]
    outside = numpy.sqrt(sum(numpy.maximum(d, 0.0) ** 2 for d in out))
    return -(outside + numpy.minimum(numpy.maximum.reduce(out), 0.0))


def contour(distance, samples):
    """The surface where distance(x, y, z) is 0, sampled on samples^3 points of [-1, 1]^3."""
    axis = numpy.linspace(-1.0, 1.0, samples)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")  # x runs fastest in VTK
    image = vtkImageData()
    image.SetDimensions(samples, samples, samples)
    image.SetOrigin(-1.0, -1.0, -1.0)
    image.SetSpacing([axis[1] - axis[0]] * 3)
    image.GetPointData().SetScalars(numpy_to_vtk(distance(x, y, z).ravel(), deep=True))
    edges = vtkFlyingEdges3D()
    edges.SetInputData(image)
    edges.SetValue(0, 0.0)
    edges.ComputeNormalsOff()
    edges.ComputeScalarsOff()
    edges.Update()
    return edges.GetOutput()


def turned(x, y, z):
    """Coordinates in which the part lies off the axes of the grid."""
    c, s = numpy.cos(0.31), numpy.sin(0.31)
    x, y = c * x - s * y, s * x + c * y
    c, s = numpy.cos(0.23), numpy.sin(0.23)
    return x, c * y - s * z, s * y + c * z


def bracket(samples):
    """The contour of an L-bracket: two boxes."""

    def distance(x, y, z):
        x, y, z = turned(x, y, z)
        base = box_distance(x, y + 0.4, z, (0.65, 0.22, 0.4))
        wall = box_distance(x + 0.43, y, z, (0.22, 0.62, 0.4))
        return numpy.maximum(base, wall)

    return contour(distance, samples)


def box(samples):
    """The contour of a box."""
    return contour(lambda x, y, z: box_distance(*turned(x, y, z), (0.6, 0.5, 0.45)), samples)


def triangles(corners):
    """Triangles on three points of their own each, from an array of n x 3 x 3 coordinates."""
    corners = numpy.asarray(corners, dtype=float)
    positions = vtkPoints()
    positions.SetData(numpy_to_vtk(corners.reshape(-1, 3), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(numpy.arange(3 * len(corners)), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(positions)
    mesh.SetPolys(cells)
    return mesh


def soup(jitter=0.0):
    """The unit cube as twelve triangles that share no points, each point up to `jitter` away."""
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    cut = [(q[0], q[k], q[k + 1]) for q in quads for k in (1, 2)]
    corners = numpy.array([[(v & 1, v >> 1 & 1, v >> 2) for v in t] for t in cut], dtype=float)
    corners += jitter * numpy.linspace(0.0, 1.0, 36).reshape(12, 3, 1) / numpy.sqrt(3.0)
    return triangles(corners)


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def copy(data):
    other = vtkPolyData()
    other.DeepCopy(data)
    return other
