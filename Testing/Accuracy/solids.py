# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Solids whose distance and sharp curves are known in closed form.

Each is turned by fixed angles, so that no face lies on the sampling grid.
"""

import numpy as np


def rotation(x, y, z):
    """The matrix that turns by these angles (degrees) about x, then y, then z."""
    cx, cy, cz = np.cos(np.radians([x, y, z]))
    sx, sy, sz = np.sin(np.radians([x, y, z]))
    return (np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
            @ np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
            @ np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]]))


def extruded(distance2d, depth, half_height):
    """Distance of a profile (its distances in the plane given) extruded to +- half_height."""
    outside = np.stack([distance2d, np.abs(depth) - half_height])
    return np.minimum(outside.max(0), 0) + np.linalg.norm(np.maximum(outside, 0), axis=0)


def polygon_distance(points, corners):
    """Signed distance in the plane from a polygon given counter-clockwise; negative inside."""
    nearest = np.full(len(points), np.inf)
    inside = np.zeros(len(points), bool)
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        along = b - a
        t = np.clip((points - a) @ along / (along @ along), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(points - a - t[:, None] * along, axis=1))
        crosses = (a[1] > points[:, 1]) != (b[1] > points[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            x = a[0] + (points[:, 1] - a[1]) / along[1] * along[0]
        inside ^= crosses & (points[:, 0] < x)
    return np.where(inside, -nearest, nearest)


class Prism:
    """A polygon extruded along z; all its edges are sharp."""

    def __init__(self, corners, half_height, turn):
        self.corners = np.array(corners, float)
        self.corners -= (self.corners.min(0) + self.corners.max(0)) / 2
        self.half_height = half_height
        self.turn = rotation(*turn)

    def distance(self, points):
        local = points @ self.turn
        return extruded(polygon_distance(local[:, :2], self.corners), local[:, 2],
                        self.half_height)

    def curves(self):
        """Polylines along the sharp edges."""
        n = len(self.corners)
        low = np.column_stack([self.corners, np.full(n, -self.half_height)])
        high = low + [0, 0, 2 * self.half_height]
        lines = [[low[i], high[i]] for i in range(n)]
        lines += [[ring[i], ring[(i + 1) % n]] for ring in (low, high) for i in range(n)]
        return [np.array(line) @ self.turn.T for line in lines]


class Cylinder:
    """A cylinder about z with flat ends; its two rims are sharp."""

    def __init__(self, radius, half_height, turn):
        self.radius = radius
        self.half_height = half_height
        self.turn = rotation(*turn)

    def distance(self, points):
        local = points @ self.turn
        return extruded(np.linalg.norm(local[:, :2], axis=1) - self.radius, local[:, 2],
                        self.half_height)

    def curves(self):
        angle = np.linspace(0, 2 * np.pi, 721)
        rim = self.radius * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
        return [(rim + [0, 0, z]) @ self.turn.T for z in (-self.half_height, self.half_height)]


SOLIDS = {
    "box": Prism([[0, 0], [1.2, 0], [1.2, 0.9], [0, 0.9]], 0.5, (11, 23, 37)),
    "cylinder": Cylinder(0.5, 0.6, (17, 29, 5)),
    "L-bracket": Prism([[0, 0], [1.3, 0], [1.3, 0.4], [0.4, 0.4], [0.4, 1.3], [0, 1.3]], 0.5,
                       (13, 19, 31)),
}
