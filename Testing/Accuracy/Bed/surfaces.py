"""Smooth surfaces of primitives in their own coordinates: exact normals and radii of curvature.

A Surface has two functions of points (n x 3): `normals` gives unit normals up to a common sign, and
`radii` the smallest radius of curvature (infinite where flat).
"""

from typing import Callable, NamedTuple

import numpy as np


class Surface(NamedTuple):
    """The exact normal and the smallest radius of curvature of one smooth surface."""

    normals: Callable
    radii: Callable


def unit(vectors):
    """Vectors divided by their length; zero stays zero."""
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def _constant(value):
    return lambda points: np.full(len(points), float(value))


def plane(normal):
    """A plane with the given normal."""
    return Surface(lambda p: np.broadcast_to(unit(np.asarray(normal, float)), p.shape),
                   _constant(np.inf))


def cylinder(radius, centre=(0, 0)):
    """A cylinder about the vertical through `centre`."""
    return Surface(lambda p: unit((p - (*centre, 0)) * (1, 1, 0)), _constant(radius))


def cone(low_radius, high_radius, height):
    """A cone about z with these radii at heights 0 and `height`."""
    slope = (low_radius - high_radius) / height

    def normals(p):
        radial = unit(p * (1, 1, 0))
        return unit(radial + (0, 0, slope))

    def radii(p):
        return np.hypot(p[:, 0], p[:, 1]) * np.hypot(1, slope)

    return Surface(normals, radii)


def sphere(radius):
    """A sphere about the origin."""
    return Surface(unit, _constant(radius))


def torus(ring, tube):
    """A torus about z: `tube` is the radius of the tube, `ring` that of its centre line."""
    return Surface(lambda p: unit(p - ring * unit(p * (1, 1, 0))), _constant(tube))


def level_set(gradient, radius):
    """A surface given by the gradient of a function; nowhere bent tighter than `radius`."""
    return Surface(lambda p: unit(gradient(p)), _constant(radius))


class Placed(NamedTuple):
    """A Surface moved by a rigid motion and oriented: what lies outside is on the normal's side."""

    surface: Surface
    rotation: np.ndarray  # row vectors: world = local @ rotation + origin
    origin: np.ndarray
    sign: float

    def local(self, points):
        """World points in the coordinates of the surface."""
        return (points - self.origin) @ self.rotation.T

    def normals(self, points):
        """Outward unit normals at world points."""
        return self.sign * self.surface.normals(self.local(points)) @ self.rotation

    def radii(self, points):
        """The smallest radius of curvature at world points."""
        return self.surface.radii(self.local(points))
