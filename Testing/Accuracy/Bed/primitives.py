"""Primitives whose every facet remembers the smooth surface that it was tessellated from.

The kernel (manifold3d) hands original ids, face ids and rigid motions through all booleans, so that
`SURFACES[original id][face id]` tells at the end which surface a facet of the result belongs to.
The unit of length is one cell of the 64^3 grid; curved faces deviate from their facets by less than
CHORD, which is 0.003 cells of the 128^3 grid.
"""

from contextlib import contextmanager

import numpy as np
from manifold3d import CrossSection, Manifold, Mesh64, OpType

import surfaces

CHORD = 0.0015
SURFACES = {}  # original id -> surface of each face id
TIPS = {}  # original id -> apexes of cones, n x 3


_chord = CHORD


@contextmanager
def coarse():
    """Within this, curved faces get a hundredth of their facets: for quick trials."""
    global _chord
    _chord = 100 * CHORD
    try:
        yield
    finally:
        _chord = CHORD


def segments(radius):
    """How many sides a circle needs to stay within CHORD; a multiple of eight."""
    return 8 * int(np.ceil(np.pi * np.sqrt(radius / (2 * _chord)) / 8))


def primitive(solid, *curved, tips=()):
    """Registers a solid: facets of the curved surfaces given, and planes for all other facets.

    The normals of the curved surfaces face outward.
    """
    mesh = solid.to_mesh64()
    points = np.array(mesh.vert_properties[:, :3], dtype=np.float64, order="C")
    tris = np.array(mesh.tri_verts, dtype=np.uint64, order="C")
    a, b, c = points[tris.astype(np.int64)].transpose(1, 0, 2)
    cross = np.cross(b - a, c - a)
    normals, centroids = surfaces.unit(cross), (a + b + c) / 3

    found = list(curved)
    face = np.full(len(tris), -1)
    for k, surface in enumerate(curved):
        cosine = (surface.normals(centroids) * normals).sum(axis=1)
        face[(face < 0) & (cosine > np.cos(np.radians(3)))] = k
    for k in np.flatnonzero(face < 0)[np.argsort(-np.linalg.norm(cross[face < 0], axis=1))]:
        if face[k] < 0:
            same = (normals @ normals[k] > 1 - 1e-10) & (face < 0)
            same &= np.abs((centroids - centroids[k]) @ normals[k]) < 1e-6
            face[same] = len(found)
            found.append(surfaces.plane(normals[k]))

    original = Manifold.reserve_ids(1)
    SURFACES[original] = found
    TIPS[original] = np.reshape(np.asarray(tips, dtype=float), (-1, 3))
    return Manifold(Mesh64(points, tris, run_index=np.array([0, tris.size], dtype=np.uint64),
                           run_original_id=np.array([original], dtype=np.uint32),
                           face_id=face.astype(np.uint64)))


def joined(solids):
    """The union of a list of solids."""
    return Manifold.batch_boolean(solids, OpType.Add)


def box(x, y, z):
    """A box about the origin."""
    return primitive(Manifold.cube((x, y, z), True))


def prism(polygon, height):
    """A polygon (n x 2, counterclockwise) extruded along z, centred in height."""
    section = CrossSection([np.asarray(polygon, dtype=float)])
    return primitive(Manifold.extrude(section, height).translate((0, 0, -height / 2)))


def regular(sides, radius):
    """The corners of a regular polygon."""
    angle = 2 * np.pi * np.arange(sides) / sides
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def hull(points):
    """The convex hull of points."""
    return primitive(Manifold.hull_points(np.asarray(points, dtype=np.float64)))


def pyramid(sides, radius, height):
    """A pyramid on a regular polygon, centred in height."""
    base = np.column_stack([regular(sides, radius), np.full(sides, -height / 2)])
    return hull(np.vstack([base, (0, 0, height / 2)]))


def wedge(length, width, height):
    """A triangular prism: a ridge of the given length above a rectangle, all about the origin."""
    x, y, z = length / 2, width / 2, height / 2
    return hull([(-x, -y, -z), (x, -y, -z), (-x, y, -z), (x, y, -z), (-x, 0, z), (x, 0, z)])


def cylinder(radius, height):
    """A capped cylinder about z, centred in height."""
    solid = Manifold.cylinder(height, radius, radius, segments(radius), True)
    return primitive(solid, surfaces.cylinder(radius))


def cone(low_radius, high_radius, height):
    """A cone or frustum about z, on the plane z = 0; a high radius of zero makes a tip."""
    solid = Manifold.cylinder(height, low_radius, high_radius, segments(low_radius))
    tips = [(0, 0, height)] if high_radius == 0 else ()
    return primitive(solid, surfaces.cone(low_radius, high_radius, height), tips=tips)


def sphere(radius):
    """A sphere about the origin; its diagonal facets need finer circles to stay within CHORD."""
    return primitive(Manifold.sphere(radius, int(1.4 * segments(radius)) // 4 * 4),
                     surfaces.sphere(radius))


def torus(ring, tube):
    """A torus about z."""
    section = CrossSection.circle(tube, segments(tube)).translate((ring, 0))
    return primitive(Manifold.revolve(section, segments(ring + tube)), surfaces.torus(ring, tube))
