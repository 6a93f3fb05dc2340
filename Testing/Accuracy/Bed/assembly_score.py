"""What a recovered assembly is worth. See the README."""

import numpy as np
from scipy.spatial import cKDTree

from meshes import Locator, Mesh
from score import AREA_SAMPLES, CURVE_STEP, along, over_area
from truth import SHARP

SAME = 1e-6  # cells: points nearer than this are one vertex


def score(truth, before, after, cell, near=0.1):
    """All figures; before and after are Meshes of the same triangles."""
    one = welded(before)
    mesh = Mesh(after.points[one.first], one.tris)
    inner, junction, free = edges_by_kind(mesh)
    figures = {}
    figures["recall"], figures["precision"], figures["false_length"] = _share_of(
        truth, truth.sharp, truth.faint, mesh, np.vstack([inner, junction]), cell, near)
    figures["junction_recall"], figures["junction_precision"], _ = _share_of(
        truth, truth.junctions, truth.junctions, mesh, junction, cell, near)
    figures["corners"] = _corners_found(truth, mesh, np.vstack([inner, junction, free]), cell, near)
    figures["free_off"] = _farthest(mesh, free, truth.points, truth.free) / cell
    there = truth.locator.closest(over_area(mesh, AREA_SAMPLES)[0])[0]
    back = Locator(mesh.points, mesh.tris).closest(over_area(truth.mesh, AREA_SAMPLES)[0])[0]
    percent = 100 / truth.mesh.diagonal()
    figures["e_mean"] = percent * (there.mean() + back.mean()) / 2
    figures["e_max"] = percent * max(there.max(), back.max())
    first = one.first[one.of]
    were_one = (before.points == before.points[first]).all(axis=1)
    are_one = (after.points == after.points[first]).all(axis=1)
    figures["gaps"] = int((were_one & ~are_one).sum())
    figures["topology"] = int(topology(before) == topology(after))
    return figures


class welded:
    """Points at one position as one: the first of them, and for each point which it is."""

    def __init__(self, mesh):
        tree = cKDTree(mesh.points)
        lowest = np.array([min(group) for group in tree.query_ball_point(mesh.points, SAME)])
        self.first, of = np.unique(lowest, return_inverse=True)
        self.of = of.reshape(-1)
        self.tris = self.of[mesh.tris]


def _edges(tris):
    """All edges (ascending), and how many triangles each has."""
    ends = np.sort(np.concatenate([tris[:, [0, 1]], tris[:, [1, 2]], tris[:, [2, 0]]]), axis=1)
    return np.unique(ends, axis=0, return_counts=True)


def edges_by_kind(mesh):
    """Sharp edges of two triangles wound either way, edges of three and more, edges of one."""
    ends, counts = _edges(mesh.tris)
    pairs, tris = mesh.edges()
    normals, _ = mesh.normals_and_areas()
    # Whether both triangles run along the edge in the same direction: one is turned round.
    along_edge = []
    for k in (0, 1):
        corners = mesh.tris[tris[:, k]]
        at = (corners == pairs[:, :1]).argmax(axis=1)
        along_edge.append(np.take_along_axis(corners, ((at + 1) % 3)[:, None], 1)[:, 0]
                          == pairs[:, 1])
    sign = np.where(along_edge[0] == along_edge[1], -1, 1)
    cosine = sign * (normals[tris[:, 0]] * normals[tris[:, 1]]).sum(axis=1)
    return pairs[cosine < np.cos(np.radians(SHARP))], ends[counts > 2], ends[counts == 1]


def topology(mesh):
    """What must not change: Euler number, components, boundary loops, edges by their triangles.

    Points count as one where they are at the very same position.
    """
    _, tris = np.unique(mesh.points[mesh.tris].reshape(-1, 3), axis=0, return_inverse=True)
    tris = tris.reshape(-1, 3)
    ends, counts = _edges(tris)
    vertices = tris.max() + 1
    return (vertices - len(ends) + len(tris), _components(vertices, ends),
            _components(vertices, ends[counts == 1], used_only=True),
            tuple(np.bincount(counts).tolist()))


def _components(count, pairs, used_only=False):
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), (count, count))
    labels = connected_components(graph, directed=False)[1]
    return len(np.unique(labels[np.unique(pairs)])) if used_only else len(np.unique(labels))


def _share_of(truth, wanted, allowed, mesh, found, cell, near):
    """Recall and precision of found edges in percent, and the length of the others in cells."""
    if not len(wanted):
        return np.nan, np.nan, np.nan
    where, length = along(truth.points, wanted, CURVE_STEP * cell)
    hit = Locator(mesh.points, found).closest(where)[0] <= near * cell
    recall = 100 * length[hit].sum() / length.sum()
    where, length = along(mesh.points, found, CURVE_STEP * cell)
    right = Locator(truth.points, allowed).closest(where)[0] <= near * cell
    return recall, 100 * length[right].sum() / length.sum(), length[~right].sum() / cell


def _corners_found(truth, mesh, found, cell, near):
    """The share of corners with a vertex of enough edges near them."""
    if not len(truth.corners):
        return np.nan
    edges_at = np.bincount(found.ravel(), minlength=len(mesh.points))
    needed = np.where(truth.valences >= 3, 3, 2)
    hits = 0
    for corner, count in zip(truth.corners, needed):
        candidates = mesh.points[edges_at >= count]
        hits += len(candidates) and np.linalg.norm(candidates - corner, axis=1).min() <= near * cell
    return 100 * hits / len(truth.corners)


def _farthest(mesh, edges, points, segments):
    """How far edges of the mesh are from segments at most."""
    if not len(edges) or not len(segments):
        return np.nan
    where, _ = along(mesh.points, edges, 0.1)
    return Locator(points, segments).closest(where)[0].max()
