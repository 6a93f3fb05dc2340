"""The surfaces between several materials as a mesh, and meshes cut apart by planes."""

import numpy as np

from meshes import Mesh

# The corners of a cell, and its edges from corner to corner along an axis.
_AXES = np.eye(3, dtype=int)


def interfaces(inside, half, resolution):
    """A mesh with one vertex in every cell that has several materials, and the patch ids.

    `inside` has one array a material, of values at the grid's points, positive where it is; the
    cube from -half to half has `resolution` cells a side. The vertex is the mean of where the
    cell's edges go from one material to another, as in surface nets; a face stands for each of
    these edges. An id is that of the pair of materials.
    """
    inside = np.stack(inside)
    label = inside.argmax(axis=0)
    cell = 2 * half / resolution
    sums, counts = np.zeros((resolution,) * 3 + (3,)), np.zeros((resolution,) * 3)
    quads, ids = [], []
    number = np.arange(resolution**3).reshape((resolution,) * 3)
    for axis in range(3):
        low, high, where = _crossings(inside, label, axis)
        point = -half + cell * where
        at = np.floor(where + 1e-9).astype(int)
        at[:, axis] = np.minimum(np.floor(where[:, axis]).astype(int), resolution - 1)
        u, w = (axis + 1) % 3, (axis + 2) % 3
        around = [at - du * _AXES[u] - dw * _AXES[w] for du, dw in ((0, 0), (1, 0), (1, 1), (0, 1))]
        for cells in around:
            np.add.at(sums, tuple(cells.T), point)
            np.add.at(counts, tuple(cells.T), 1)
        quad = np.stack([number[tuple(cells.T)] for cells in around], axis=1)
        quad[low < high] = quad[low < high][:, ::-1]  # faces look from the higher to the lower
        quads.append(quad)
        ids.append(np.minimum(low, high) * len(inside) + np.maximum(low, high))
    used = counts > 0
    points = sums[used] / counts[used][:, None]
    new = np.full(resolution**3, -1)
    new[number[used]] = np.arange(len(points))
    quads, ids = new[np.vstack(quads)], np.concatenate(ids)
    return Mesh(points, _halved(points, quads)), np.repeat(ids, 2)


def _crossings(inside, label, axis):
    """Grid edges along an axis between two materials: these, and where (in cells) they change."""
    low = np.take(label, range(label.shape[axis] - 1), axis=axis)
    high = np.take(label, range(1, label.shape[axis]), axis=axis)
    start = np.argwhere(low != high)
    end = start + _AXES[axis]
    a, b = label[tuple(start.T)], label[tuple(end.T)]
    before = inside[(a, *start.T)] - inside[(b, *start.T)]
    after = inside[(a, *end.T)] - inside[(b, *end.T)]
    where = start.astype(float)
    where[:, axis] += before / (before - after)
    return a, b, where


def _halved(points, quads):
    """Two triangles for each quadrangle, cut along its shorter diagonal."""
    corners = points[quads]
    first = np.linalg.norm(corners[:, 2] - corners[:, 0], axis=1)
    turned = first > np.linalg.norm(corners[:, 3] - corners[:, 1], axis=1)
    quads = np.where(turned[:, None], np.roll(quads, -1, axis=1), quads)
    return quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)


def plane_cut(points, tris, height):
    """The segments in which triangles cross height zero: points and pairs of them."""
    ends = []
    for k in range(3):
        a, b = tris[:, k], tris[:, (k + 1) % 3]
        crosses = (height[a] < 0) != (height[b] < 0)
        t = np.where(crosses, height[a] / np.where(crosses, height[a] - height[b], 1), np.nan)
        ends.append(points[a] + t[:, None] * (points[b] - points[a]))
    ends = np.stack(ends, axis=1)
    found = ~np.isnan(ends[:, :, 0])
    crossed = found.sum(axis=1) == 2
    cut = ends[crossed][found[crossed]]
    return cut, np.arange(len(cut)).reshape(-1, 2)


def clip_segments(points, segments, normal, level):
    """The parts of segments below a plane: points and pairs of them."""
    ends = points[segments]
    height = ends @ normal - level
    ends, height = ends[(height < 0).any(axis=1)], height[(height < 0).any(axis=1)]
    for k in (0, 1):
        above = height[:, k] > 0
        t = height[above, 1 - k] / (height[above, 1 - k] - height[above, k])
        ends[above, k] = ends[above, 1 - k] + t[:, None] * (ends[above, k] - ends[above, 1 - k])
    return ends.reshape(-1, 3), np.arange(2 * len(ends)).reshape(-1, 2)


def cut_apart(mesh, normal, level, both):
    """A mesh cut by a plane: the part below it, and if asked for the other behind it.

    Triangles across the plane are cut in three, with the new points on it; the two parts share none.
    """
    height = mesh.points @ normal - level
    height[np.abs(height) < 1e-9] = 1e-9
    sides, points = {True: [], False: []}, list(mesh.points)
    new = {}

    def crossing(a, b):
        key = min(a, b), max(a, b)
        if key not in new:
            a, b = key
            t = height[a] / (height[a] - height[b])
            new[key] = len(points)
            points.append(mesh.points[a] + t * (mesh.points[b] - mesh.points[a]))
        return new[key]

    below = height < 0
    for tri in mesh.tris:
        under = below[tri]
        if under.all() or not under.any():
            sides[bool(under[0])].append(tri)
            continue
        lone = int(np.flatnonzero(under == (under.sum() == 1))[0])
        a, b, c = np.roll(tri, -lone)
        p, q = crossing(a, b), crossing(a, c)
        sides[bool(below[a])].append((a, p, q))
        sides[bool(below[b])] += [(p, b, c), (p, c, q)]
    points = np.array(points)
    parts, offset, all_points = [], 0, []
    for side in (True, False) if both else (True,):
        tris = np.array(sides[side])
        used, local = np.unique(tris, return_inverse=True)
        parts.append(local.reshape(-1, 3) + offset)
        all_points.append(points[used])
        offset += len(used)
    return Mesh(np.vstack(all_points), np.vstack(parts)), None
