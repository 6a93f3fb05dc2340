"""Pairs of triangles of one mesh that cross each other."""

import numpy as np

TOUCH = 1e-9  # a volume below this, relative to its triangles' size cubed, counts as touching
MOST_BINS = 2_000_000


def crossing_pairs(mesh, among=None):
    """Pairs of triangle ids (k x 2, sorted) that cross; only pairs with one in `among` if given.

    Two triangles cross if an edge of one passes through the inside of the other. Touching does not
    count, nor do overlaps within one plane, and neighbours across an edge are never asked: a fold
    shows among the flipped triangles.
    """
    pairs = _candidates(mesh, among)
    if not len(pairs):
        return pairs
    hit = np.zeros(len(pairs), dtype=bool)
    for one, two in ((0, 1), (1, 0)):
        edges_of, faces = mesh.tris[pairs[:, one]], mesh.tris[pairs[:, two]]
        for k in range(3):
            p, q = edges_of[:, k], edges_of[:, (k + 1) % 3]
            apart = ~((faces == p[:, None]) | (faces == q[:, None])).any(axis=1)
            ask = np.flatnonzero(apart & ~hit)
            hit[ask] = _passes_through(mesh.points, p[ask], q[ask], faces[ask])
    return pairs[hit]


def _candidates(mesh, among):
    """Pairs whose bounding boxes overlap, without neighbours across an edge; by a grid of bins."""
    corners = mesh.corners()
    low, high = corners.min(axis=1), corners.max(axis=1)
    asked = np.ones(len(mesh.tris), dtype=bool)
    if among is not None:
        asked[:] = False
        asked[among] = True
        if not asked.any():
            return np.zeros((0, 2), dtype=np.int64)
        near = ((high >= low[asked].min(axis=0)) & (low <= high[asked].max(axis=0))).all(axis=1)
    else:
        near = asked

    size = max(np.percentile((high - low).max(axis=1), 75), 1e-300)
    origin = low.min(axis=0)
    while True:
        first = ((low - origin) / size).astype(np.int64)
        counts = ((high - origin) / size).astype(np.int64) - first + 1
        if counts[near].prod(axis=1).sum() < MOST_BINS + 20 * near.sum():
            break
        size *= 2
    owner, bins = _bins(np.flatnonzero(near), first, counts)
    occupied = np.unique(bins[asked[owner]])
    keep = np.isin(bins, occupied)
    pairs = _pairs_within(owner[keep], bins[keep])
    pairs = pairs[asked[pairs].any(axis=1)]
    a, b = pairs.T
    pairs = pairs[((low[a] <= high[b]) & (low[b] <= high[a])).all(axis=1)]
    pairs = np.unique(pairs, axis=0)
    shared = (mesh.tris[pairs[:, 0]][:, :, None] == mesh.tris[pairs[:, 1]][:, None, :])
    return pairs[shared.sum(axis=(1, 2)) < 2]


def _bins(tris, first, counts):
    """Every (triangle, bin) such that the triangle's box touches the bin."""
    repeats = counts[tris].prod(axis=1)
    owner = np.repeat(tris, repeats)
    k = np.arange(len(owner)) - np.repeat(np.cumsum(repeats) - repeats, repeats)
    nx, ny, _ = counts[owner].T
    cell = first[owner] + np.stack([k % nx, k // nx % ny, k // (nx * ny)], axis=1)
    extent = (first + counts).max(axis=0)
    return owner, (cell[:, 0] * extent[1] + cell[:, 1]) * extent[2] + cell[:, 2]


def _pairs_within(owner, bins):
    """All pairs (smaller id first) of triangles in the same bin, with repetitions."""
    order = np.lexsort((owner, bins))
    owner, bins = owner[order], bins[order]
    end = np.searchsorted(bins, bins, side="right")
    later = end - np.arange(len(bins)) - 1
    one = np.repeat(np.arange(len(bins)), later)
    two = one + 1 + np.arange(len(one)) - np.repeat(np.cumsum(later) - later, later)
    return np.stack([owner[one], owner[two]], axis=1)


def _passes_through(points, p, q, faces):
    """Whether segments pq pass through the insides of triangles."""
    p, q = points[p], points[q]
    a, b, c = points[faces].transpose(1, 0, 2)
    size = np.linalg.norm(b - a, axis=1) + np.linalg.norm(c - a, axis=1) \
        + np.linalg.norm(q - p, axis=1)
    touch = TOUCH * size**3
    above, below = _volume(p, a, b, c), _volume(q, a, b, c)
    sides = np.stack([_volume(p, q, a, b), _volume(p, q, b, c), _volume(p, q, c, a)])
    through = (sides > touch).all(axis=0) | (sides < -touch).all(axis=0)
    opposite = ((above > touch) & (below < -touch)) | ((above < -touch) & (below > touch))
    return through & opposite


def _volume(a, b, c, d):
    """Six times the signed volume of tetrahedra."""
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a))
