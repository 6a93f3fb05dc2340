"""Random parts by seed: three to five primitives joined or cut at random places and angles.

Development looks at DEVELOPMENT_SEEDS. HELD_OUT_SEEDS are for the final figure only: a constant
that was chosen after looking at them makes that figure worthless.
"""

import numpy as np
from scipy.spatial import cKDTree

import primitives
from primitives import box, cone, cylinder, prism, regular, sphere, wedge
from truth import Truth

DEVELOPMENT_SEEDS = range(0, 12)
HELD_OUT_SEEDS = range(100, 112)
REACH = 28.0  # cells (at 64^3) from the centre of the grid that a part may reach
SMALLEST = 2.0  # cells (at 64^3): nothing of a part is thinner, and no two corners are nearer
SHORTEST = 150.0  # cells (at 64^3): the total length of sharp curves is not less
ATTEMPTS = 1000


def random_part(seed):
    """The part of a seed: the first of its attempts that is not degenerate."""
    for attempt in range(ATTEMPTS):
        with primitives.coarse():
            usable = _is_usable(_attempt(np.random.default_rng([seed, attempt])))
        if usable:
            solid = _attempt(np.random.default_rng([seed, attempt]))
            if _is_usable(solid):
                return solid
    raise RuntimeError(f"seed {seed}: no usable part in {ATTEMPTS} attempts")


def _attempt(rng):
    """Joins and cuts primitives; the first two are joined, so that there is something to cut."""
    solid = _primitive(rng, large=True)
    for k in range(rng.integers(2, 5)):
        piece = _primitive(rng, large=k == 0).translate(rng.uniform(-14, 14, 3))
        solid = solid + piece if k == 0 or rng.random() < 0.4 else solid - piece
    low, high = np.array(solid.bounding_box()).reshape(2, 3)
    return solid.translate(rng.uniform(-1, 1, 3) - (low + high) / 2)


def _primitive(rng, large):
    """A box, cylinder, cone or frustum, prism, sphere or wedge, turned at random."""
    size = rng.uniform(14, 22, 3) if large else rng.uniform(8, 16, 3)
    kind = rng.choice(["box", "cylinder", "cone", "prism", "sphere", "wedge"])
    if kind == "box":
        solid = box(*(1.6 * size))
    elif kind == "cylinder":
        solid = cylinder(0.75 * size[0], 2 * size[1])
    elif kind == "cone":
        top = rng.choice([0, 0.5]) * size[0]
        solid = cone(size[0], top, 1.8 * size[1]).translate((0, 0, -0.9 * size[1]))
    elif kind == "prism":
        solid = prism(regular(rng.choice([3, 5, 6]), size[0]), 1.8 * size[1])
    elif kind == "sphere":
        solid = sphere(size[0])
    else:
        solid = wedge(1.8 * size[0], 1.8 * size[1], 1.4 * size[2])
    return solid.rotate(rng.uniform(0, 360, 3))


def _is_usable(solid):
    """Whether a part is worth measuring: cheap questions first."""
    return _is_one_part(solid) and _is_worth_measuring(Truth(solid))


def _is_one_part(solid):
    """Whether the part is in one piece, has a fair volume and fits into the grid."""
    if solid.is_empty() or solid.volume() < 4000 or len(solid.decompose()) != 1:
        return False
    return np.abs(solid.bounding_box()).max() < REACH


def _is_worth_measuring(truth):
    """Whether there are edges, and no corners, walls, gaps or faces smaller than SMALLEST."""
    if truth.curve_length() < SHORTEST:
        return False
    if len(truth.corners) > 1 and cKDTree(truth.corners).query(truth.corners, 2)[0][:, 1].min() \
            < SMALLEST:
        return False
    _, areas = truth.mesh.normals_and_areas()
    if np.bincount(truth.surface_of, areas).min() < 3 * SMALLEST**2:
        return False
    return not _has_thin_places(truth)


def _has_thin_places(truth):
    """Whether, away from sharp edges, something lies nearer than SMALLEST behind or before a face.

    A point half of SMALLEST off such a face is nearer to something else than to the face itself.
    """
    centroids = truth.mesh.centroids()
    intact = truth.distance_to_features(centroids) > 1.5 * SMALLEST
    tris = np.flatnonzero(intact)
    normals = truth.normals(centroids[tris], tris)
    for side in (-1, 1):
        moved = centroids[tris] + side * SMALLEST / 2 * normals
        if (truth.locator.closest(moved)[0] < 0.8 * SMALLEST / 2).any():
            return True
    return False
