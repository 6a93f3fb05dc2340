"""What an output mesh is worth against the truth, and what it did to its input. See the README.

`score(truth, before, after, cell)` returns a dictionary; `cell` is the width of a cell of the
sampling. Shares are in percent, and nan where there is nothing to have a share of.
"""

import numpy as np
from scipy.spatial import cKDTree

from crossings import crossing_pairs
from meshes import Locator
from truth import SHARP

NEAR = 0.1  # cells: how near a sharp edge or corner has to be
TIGHT = 3.5  # cells: sharp edges beside a smooth surface bent tighter than this are not judged
TIGHT_REACH = 1.0  # cells from such a surface
INTACT = 2.0  # cells from all sharp curves and tips: vertices farther away ought not to move
MOVED = 1e-9  # diagonals of the bounding box
SLIVER = 1.0  # degrees
CURVE_STEP, AREA_SAMPLES = 0.05, 30000
SEED = 7


def score(truth, before, after, cell, near=NEAR):
    """All figures of one mesh."""
    figures = edge_figures(truth, after, cell, near)
    figures.update(corner_figures(truth, after, cell, near))
    figures.update(distance_figures(truth, after))
    figures.update(damage_figures(truth, before, after, cell))
    return figures


def sharp_edges(mesh):
    """The mesh edges (pairs of points) whose triangles' normals differ by more than SHARP."""
    ends, tris = mesh.edges()
    normals, areas = mesh.normals_and_areas()
    cosine = (normals[tris[:, 0]] * normals[tris[:, 1]]).sum(axis=1)
    flat = (areas[tris] <= 1e-14 * mesh.diagonal() ** 2).any(axis=1)
    return ends[(cosine < np.cos(np.radians(SHARP))) & ~flat]


def along(points, segments, step):
    """Points along segments, and the length that each stands for."""
    start, way = points[segments[:, 0]], points[segments[:, 1]] - points[segments[:, 0]]
    length = np.linalg.norm(way, axis=1)
    count = np.maximum(np.ceil(length / step).astype(int), 1)
    owner = np.repeat(np.arange(len(segments)), count)
    k = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
    t = (k + 0.5) / count[owner]
    return start[owner] + t[:, None] * way[owner], (length / count)[owner]


def over_area(mesh, count):
    """`count` random points spread evenly over the mesh, and their triangles."""
    rng = np.random.default_rng(SEED)
    _, areas = mesh.normals_and_areas()
    total = np.cumsum(areas)
    steps = (np.arange(count) + rng.random(count)) / count * total[-1]
    tri = np.minimum(np.searchsorted(total, steps), len(areas) - 1)
    u, v = rng.random((2, count))
    beyond = u + v > 1
    u[beyond], v[beyond] = 1 - u[beyond], 1 - v[beyond]
    a, b, c = mesh.corners()[tri].transpose(1, 0, 2)
    return a + u[:, None] * (b - a) + v[:, None] * (c - a), tri


def edge_figures(truth, mesh, cell, near):
    """Recall and precision of sharp edge length, and the length of false edges in cells."""
    figures = curve_figures(truth, mesh.points, sharp_edges(mesh), cell, near)
    return {name: figures[name] for name in ("recall", "precision", "false_length")}


def curve_figures(truth, points, found, cell, near):
    """The same for edges that were found in any way: pairs of point ids. And the length of those
    that are judged, which leaves out what is neither right nor held against them."""
    where, length = along(truth.mesh.points, truth.segments, CURVE_STEP * cell)
    hit = Locator(points, found).closest(where)[0] <= near * cell
    recall = _share(length[hit].sum(), length.sum())

    where, length = along(points, found, CURVE_STEP * cell)
    right = Locator(truth.mesh.points, truth.faint_segments).closest(where)[0] <= near * cell
    wrong = ~right
    wrong[wrong] = ~_beside_tight_bend(truth, where[wrong], cell)
    right, wrong = length[right].sum(), length[wrong].sum()
    precision = _share(right, right + wrong) if len(truth.segments) else np.nan
    return {"recall": recall, "precision": precision, "false_length": wrong / cell,
            "judged_length": right + wrong}


def _beside_tight_bend(truth, points, cell):
    """Whether the nearest smooth surface, or one within TIGHT_REACH, bends tighter than TIGHT."""
    centroids = truth.mesh.centroids()
    tight = truth.radii(centroids, np.arange(len(centroids))) < TIGHT * cell
    return Locator(truth.mesh.points, truth.mesh.tris[tight]).closest(points)[0] \
        < TIGHT_REACH * cell


def corner_figures(truth, mesh, cell, near):
    """The share of true corners that have an output vertex with enough sharp edges near them."""
    if not len(truth.corners):
        return {"corners": np.nan}
    edges_at = np.bincount(sharp_edges(mesh).ravel(), minlength=len(mesh.points))
    needed = np.where(truth.valences >= 3, 3, np.where(truth.valences == 2, 2, 1))
    found = np.zeros(len(truth.corners), dtype=bool)
    for count in np.unique(needed):
        candidates = mesh.points[edges_at >= count]
        if len(candidates):
            distance, _ = cKDTree(candidates).query(truth.corners)
            found |= (needed == count) & (distance <= near * cell)
    return {"corners": _share(found.sum(), len(found))}


def distance_figures(truth, mesh):
    """Mean and largest distance both ways in % of the diagonal; RMS normal deviation in degrees."""
    there, tri = over_area(mesh, AREA_SAMPLES)
    far, nearest_tri, nearest = truth.locator.closest(there)
    back = Locator(mesh.points, mesh.tris).closest(over_area(truth.mesh, AREA_SAMPLES)[0])[0]
    vertices = truth.locator.closest(mesh.points)[0]
    normals, _ = mesh.normals_and_areas()
    cosine = (normals[tri] * truth.normals(nearest, nearest_tri)).sum(axis=1)
    deviation = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
    percent = 100 / truth.mesh.diagonal()
    return {"e_mean": percent * (far.mean() + back.mean()) / 2,
            "e_max": percent * max(far.max(), back.max(), vertices.max()),
            "normal_rms": np.sqrt((deviation**2).mean())}


def damage_figures(truth, before, after, cell):
    """New flipped, degenerate and crossing triangles, and vertices moved where all was well."""
    same = np.array_equal(before.tris, after.tris)
    figures = {}
    for name, find in (("flips", lambda mesh: flipped(truth, mesh, cell)),
                       ("slivers", lambda mesh: mesh.smallest_angles() < SLIVER)):
        bad_after, bad_before = find(after), find(before)
        figures[name] = int((bad_after & ~bad_before).sum()) if same \
            else max(int(bad_after.sum()) - int(bad_before.sum()), 0)
    figures["crossings"] = _new_crossings(before, after, same)

    intact = truth.distance_to_features(before.points) > INTACT * cell
    if same:
        moved = np.linalg.norm(after.points - before.points, axis=1)
    else:
        moved = cKDTree(after.points).query(before.points)[0]
    moved = moved > MOVED * truth.mesh.diagonal()
    figures["far_moved"] = _share((moved & intact).sum(), intact.sum())
    return figures


def flipped(truth, mesh, cell):
    """Which triangles face the wrong way: more than 90 degrees off every true normal near them.

    Near means: of the nearest point of the surface, and of all samples of the surface within a
    quarter of a cell of the centroid or up to 1.2 times as far as the nearest, so that at an acute
    edge a triangle of one side is not judged by the normals of the other.
    """
    centroids = mesh.centroids()
    normals, areas = mesh.normals_and_areas()
    distance, tri, nearest = truth.locator.closest(centroids)
    against = (normals * truth.normals(nearest, tri)).sum(axis=1) < 0
    suspects = np.flatnonzero(against & (areas > 1e-14 * truth.mesh.diagonal() ** 2))
    if not len(suspects):
        return against
    samples, sample_tris = over_area(truth.mesh, 8 * AREA_SAMPLES)
    tree, sample_normals = cKDTree(samples), truth.normals(samples, sample_tris)
    against[:] = False
    reach = np.maximum(cell / 4, 1.2 * distance[suspects])
    for t, near in zip(suspects, tree.query_ball_point(centroids[suspects], reach)):
        against[t] = (sample_normals[near] @ normals[t] < 0).all()
    return against


def _new_crossings(before, after, same):
    """How many pairs of triangles cross after but did not before."""
    if not same:
        return max(len(crossing_pairs(after)) - len(crossing_pairs(before)), 0)
    moved = (before.points != after.points).any(axis=1)
    changed = np.flatnonzero(moved[after.tris].any(axis=1))
    now, once = crossing_pairs(after, changed), crossing_pairs(before, changed)
    key = len(after.tris)
    return len(np.setdiff1d(now[:, 0] * key + now[:, 1], once[:, 0] * key + once[:, 1]))


def _share(part, whole):
    return 100.0 * part / whole if whole > 0 else np.nan
