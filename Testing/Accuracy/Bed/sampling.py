"""How a solid becomes the mesh that a user would have: contours, remeshings, scans.

A sampling is named by kind and resolution, such as contour64: the cube from -32 to 32 in 64 cells a
side. `sampled(truth, name)` makes the mesh.
"""

import re

import igl
import numpy as np
import pymeshlab
from scipy.ndimage import gaussian_filter
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import (vtkFlyingEdges3D, vtkQuadricDecimation,
                                       vtkWindowedSincPolyDataFilter)

from meshes import Mesh, from_polydata, to_polydata

HALF = 32.0  # the grid reaches from -HALF to HALF
BLEND = 0.8  # cells: width of the Gaussian of a blended distance
VOXEL_BLUR = 1.0  # cells: width of the Gaussian of a segmentation
DECIMATED = 0.5  # share of triangles taken away
PASS_BAND, ITERATIONS = 0.1, 20  # of the smoothing: VTK's defaults
LIGHT, HEAVY = 0.1, 0.3  # noise, in mean edge lengths
SHEAR = 0.5  # of the irregular sampling: edges vary about twofold in length
CLEAR = 0.15  # cells: the irregular sampling keeps its vertices this far from sharp curves
SEED = 20240229


def sampled(truth, name):
    """The mesh of a truth under the sampling of this name, facing outward."""
    kind, resolution = parse(name)
    return KINDS[kind](truth, resolution)


def parse(name):
    """Kind and resolution, so ('contour', 64) for 'contour64'."""
    match = re.fullmatch(r"([a-z]+)(\d+)", name)
    if not match or match[1] not in KINDS or int(match[2]) not in (32, 64, 128, 256):
        raise ValueError(f"{name}: a sampling is one of {', '.join(KINDS)}, "
                         "followed by 32, 64, 128 or 256")
    return match[1], int(match[2])


def cell_size(name):
    """The width of a cell of this sampling; the unit is a cell of 64^3."""
    return 2 * HALF / parse(name)[1]


def contour(truth, resolution):
    """The contour of the exact distance."""
    return _flying_edges(distances(truth, resolution, band=2), 0)


def snapped(truth, resolution):
    """The contour with every vertex moved to the nearest point of the surface."""
    mesh = contour(truth, resolution)
    return Mesh(truth.locator.closest(mesh.points)[2], mesh.tris)


def blended(truth, resolution):
    """The contour of the distance blurred by BLEND, as of a volume resampled or filtered."""
    blurred = gaussian_filter(distances(truth, resolution, band=6), BLEND, mode="nearest")
    return _flying_edges(blurred, 0)


def segmentation(truth, resolution):
    """Voxels inside or outside, blurred by VOXEL_BLUR and contoured half-way."""
    inside = (distances(truth, resolution, band=1) < 0).astype(float)
    return _flying_edges(-gaussian_filter(inside, VOXEL_BLUR, mode="nearest"), -0.5)


def decimated(truth, resolution):
    """The contour with DECIMATED of its triangles taken away, most of them in flat places."""
    decimation = vtkQuadricDecimation()
    decimation.SetTargetReduction(DECIMATED)
    return _filtered(contour(truth, resolution), decimation)


def smoothed(truth, resolution):
    """The contour smoothed by a windowed sinc, as many do with every contour."""
    smoothing = vtkWindowedSincPolyDataFilter()
    smoothing.SetPassBand(PASS_BAND)
    smoothing.SetNumberOfIterations(ITERATIONS)
    return _filtered(contour(truth, resolution), smoothing)


def lightnoise(truth, resolution):
    """The contour with Gaussian noise of LIGHT mean edge lengths."""
    return _noisy(contour(truth, resolution), LIGHT)


def heavynoise(truth, resolution):
    """The contour with Gaussian noise of HEAVY mean edge lengths."""
    return _noisy(contour(truth, resolution), HEAVY)


def irregular(truth, resolution):
    """Vertices on the surface, none on a sharp curve, with edges of varying length and direction.

    The contour is remeshed isotropically in a sheared copy of space, brought back, and its vertices
    moved to the surface; those that come close to a sharp curve go part of the way to the middle of
    their neighbours, which lie on one side of it or, through the solid or the air, beyond it.
    """
    cell = 2 * HALF / resolution
    mesh = contour(truth, resolution)
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(_shear(mesh.points, 1), mesh.tris))
    meshes.meshing_isotropic_explicit_remeshing(
        iterations=6, featuredeg=180, targetlen=pymeshlab.PureValue(cell), checksurfdist=False)
    result = meshes.current_mesh()
    mesh = Mesh(_shear(result.vertex_matrix(), -1), result.face_matrix().astype(np.int64))
    points = truth.locator.closest(mesh.points)[2]
    for _ in range(8):
        near = truth.curve_locator.closest(points)[0] < CLEAR * cell
        middles = _neighbour_middles(points, mesh.tris)
        points[near] = truth.locator.closest((points[near] + middles[near]) / 2)[2]
    return Mesh(points, mesh.tris)


KINDS = {f.__name__: f for f in (contour, snapped, irregular, decimated, smoothed, blended,
                                 segmentation, lightnoise, heavynoise)}


def distances(truth, resolution, band):
    """Signed distances on the grid, negative inside: exact where below `band` cells.

    Elsewhere they have the right sign and are too small. From strides of up to eight grid points down
    to one, a point takes the value of the coarser neighbour less the way to it, and is asked exactly
    only if that is inside the band.
    """
    cell, values = 2 * HALF / resolution, np.zeros((1, 1, 1))
    strides = [stride for stride in (8, 4, 2, 1) if resolution % stride == 0]
    for stride in strides:
        axis = np.linspace(-HALF, HALF, resolution // stride + 1)
        if stride == strides[0]:
            bound = np.zeros((len(axis),) * 3)
            sign = bound
        else:
            nearest = (np.arange(len(axis)) + 1) // 2
            coarse = values[np.ix_(nearest, nearest, nearest)]
            bound = np.abs(coarse) - np.sqrt(3) * stride * cell
            sign = np.sign(coarse)
        values = sign * bound
        active = np.flatnonzero(bound < band * cell)
        where = np.stack(np.unravel_index(active, values.shape), axis=1)
        values.ravel()[active] = igl.signed_distance(
            axis[where], truth.mesh.points, truth.mesh.tris,
            igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER)[0]
    return np.clip(values, -band * cell, band * cell)


def _filtered(mesh, algorithm):
    """The output of a filter of VTK."""
    algorithm.SetInputData(to_polydata(mesh.points, mesh.tris))
    algorithm.Update()
    return from_polydata(algorithm.GetOutput())


def _flying_edges(values, level):
    """The contour of a grid of values that grow outward."""
    image = vtkImageData()
    image.SetDimensions(values.shape)
    image.SetOrigin(-HALF, -HALF, -HALF)
    image.SetSpacing(*[2 * HALF / (n - 1) for n in values.shape])
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(order="F"), deep=True))
    contours = vtkFlyingEdges3D()
    contours.SetInputData(image)
    contours.SetValue(0, level)
    contours.ComputeNormalsOff()
    contours.ComputeScalarsOff()
    contours.Update()
    mesh = from_polydata(contours.GetOutput())
    return mesh if mesh.volume() > 0 else Mesh(mesh.points, mesh.tris[:, ::-1].copy())


def _noisy(mesh, amount):
    """Every vertex moved by isotropic Gaussian noise of so many mean edge lengths."""
    noise = np.random.default_rng(SEED).normal(size=mesh.points.shape)
    return Mesh(mesh.points + amount * mesh.mean_edge_length() * noise, mesh.tris)


def _shear(points, direction):
    """Three smooth shears of space that keep volumes; direction -1 undoes direction 1."""
    points, wave = points.copy(), np.pi / HALF
    for axis in (0, 1, 2)[::direction]:
        phase = wave * points[:, (axis + 1) % 3] + axis
        points[:, axis] += direction * SHEAR / wave * np.sin(phase)
    return points


def _neighbour_middles(points, tris):
    """The mean of the neighbours of each vertex, by triangles."""
    total, count = np.zeros_like(points), np.bincount(tris.ravel(), minlength=len(points))
    for k in (1, 2):
        for axis in range(3):
            total[:, axis] += np.bincount(tris.ravel(), points[np.roll(tris, -k, 1), axis].ravel(),
                                          minlength=len(points))
    return total / np.maximum(2 * count, 1)[:, None]
