# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""What a recovered mesh is worth against the exact solid it was sampled from."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator

SHARP = 20.0  # degrees between the normals of a mesh edge from which on it counts as sharp
NEAR = 0.1    # cells within which a sharp edge counts as found


def arrays(mesh):
    """Points and triangles of a vtkPolyData."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    return points, vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def area_vectors(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a) / 2


def sharp_edges(points, triangles):
    """The mesh edges (pairs of vertices) whose two triangles differ by more than SHARP."""
    normals = area_vectors(points, triangles)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]],
                                    triangles[:, [2, 0]]]), axis=1)
    faces = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    edges, faces = edges[order], faces[order]
    pairs = np.flatnonzero((edges[:-1] == edges[1:]).all(1))
    cosine = (normals[faces[pairs]] * normals[faces[pairs + 1]]).sum(1)
    return edges[pairs][cosine < np.cos(np.radians(SHARP))]


def sampled(segments, step):
    """Points along segments (n x 2 x 3), and the length each of them stands for."""
    lengths = np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1)
    counts = np.maximum(1, np.ceil(lengths / step)).astype(int)
    which = np.repeat(np.arange(len(segments)), counts)
    first = np.repeat(np.cumsum(counts) - counts, counts)
    t = (np.arange(counts.sum()) - first + 0.5) / counts[which]
    along = segments[which, 1] - segments[which, 0]
    return segments[which, 0] + t[:, None] * along, (lengths / counts)[which]


def distances(points, targets):
    """The distance from each point to the nearest target."""
    cloud = vtkPolyData()
    holder = vtkPoints()
    holder.SetData(numpy_to_vtk(np.ascontiguousarray(targets), deep=True))
    cloud.SetPoints(holder)
    locator = vtkStaticPointLocator()
    locator.SetDataSet(cloud)
    locator.BuildLocator()
    nearest = np.array([locator.FindClosestPoint(p) for p in points])
    return np.linalg.norm(points - targets[nearest], axis=1)


def share_near(segments, others, cell):
    """The part of the segments' length with another one within NEAR cells."""
    if len(segments) == 0 or len(others) == 0:
        return 0.0
    step = 0.02 * cell
    points, lengths = sampled(segments, 0.1 * cell)
    targets, _ = sampled(others, step)
    return lengths[distances(points, targets) <= NEAR * cell].sum() / lengths.sum()


def mean_distance(solid, mesh):
    """The mean distance of the mesh from the solid's surface, weighted by area."""
    points, triangles = arrays(mesh)
    areas = np.linalg.norm(area_vectors(points, triangles), axis=1)
    # The three edge midpoints and the centroid: enough, as triangles are under a cell wide.
    total = 0.0
    for weights in ((1, 1, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1)):
        weights = np.array(weights) / sum(weights)
        at = np.einsum("k,tkx->tx", weights, points[triangles])
        total += (areas * np.abs(solid.distance(at))).sum()
    return total / (4 * areas.sum())


def score(solid, before, after, cell):
    """A dictionary of figures; lengths in cells, shares in percent."""
    truth = np.concatenate([np.stack([curve[:-1], curve[1:]], axis=1)
                            for curve in solid.curves()])
    points, triangles = arrays(after)
    found = points[sharp_edges(points, triangles)]
    intact = vtk_to_numpy(after.GetPointData().GetArray("SharpRegion")) == 0
    return {
        "triangles": len(triangles),
        "recall": 100 * share_near(truth, found, cell),
        "precision": 100 * share_near(found, truth, cell),
        "distance before": mean_distance(solid, before) / cell,
        "distance after": mean_distance(solid, after) / cell,
        "intact moved": int((arrays(before)[0][intact] != points[intact]).any(1).sum()),
    }
