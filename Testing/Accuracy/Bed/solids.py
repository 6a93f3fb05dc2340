"""The designed solids: each asks one question of a method. See their docstrings.

The unit of length is one cell of the 64^3 grid, which reaches from -32 to 32. Unless its name says
`aligned`, a solid is turned by fixed angles so that no face lies along the grid.
"""

import numpy as np
from manifold3d import CrossSection, Manifold, Mesh64

import primitives
import surfaces
from primitives import box, cone, cylinder, joined, prism, pyramid, regular, sphere, torus

SOLIDS = {}  # name -> function that makes the solid


def designed(aligned=False):
    """Registers a function as a designed solid, and turns what it makes."""
    def register(function):
        def make():
            if aligned:
                return function().translate((0.37, -0.41, 0.23))
            index = list(SOLIDS).index(function.__name__)
            angles = (17 + 11 * index) % 83 + 5, (31 + 17 * index) % 79 + 5, 23 + 13 * index % 61
            return function().rotate(angles).translate((0.3, -0.2, 0.1))
        make.__doc__ = function.__doc__
        SOLIDS[function.__name__] = make
        return function
    return register


@designed(aligned=True)
def box_aligned():
    """Twelve straight edges and eight corners, along the grid."""
    return box(37, 31, 25)


@designed()
def box_rotated():
    """Twelve straight edges and eight corners."""
    return box(37, 31, 25)


@designed()
def pyramid4():
    """A corner of valence four; acute edges."""
    return pyramid(4, 25, 32)


@designed()
def pyramid5():
    """A corner of valence five."""
    return pyramid(5, 25, 28)


@designed()
def pyramid6():
    """A corner of valence six and shallow edges beside it."""
    return pyramid(6, 26, 20)


@designed()
def l_bracket():
    """Convex and concave straight edges, mixed corners and two drilled holes."""
    bracket = box(40, 24, 10).translate((0, 0, -11)) + box(10, 24, 32).translate((-15, 0, 0))
    bracket -= cylinder(5, 30).translate((9, 0, -10))
    return bracket - cylinder(6, 30).rotate((0, 90, 0)).translate((-15, 0, 6))


@designed(aligned=True)
def stairs_aligned():
    """Steps along the grid: alternating convex and concave edges and mixed corners."""
    steps = [box(9, 24, 8 * (k + 1)).translate((9 * k - 13.5, 0, 4 * (k + 1) - 16))
             for k in range(4)]
    return joined(steps)


@designed()
def cross():
    """Three bars through each other: concave corners of three faces, convex ends."""
    return box(44, 13, 13) + box(13, 44, 15) + box(15, 11, 44)


@designed()
def prism150():
    """150 degrees between the side faces (a regular twelve-gon)."""
    return prism(regular(12, 22), 28)


@designed()
def ridge150():
    """One shallow ridge of 150 degrees on a block."""
    rise = 18 * np.tan(np.radians(15))
    return prism([(-18, -12), (18, -12), (18, 8), (0, 8 + rise), (-18, 8)], 36)


@designed()
def prism120():
    """120 degrees between the side faces (a regular hexagon)."""
    return prism(regular(6, 22), 28)


@designed()
def prism60():
    """60 degrees between the side faces (a regular triangle)."""
    return prism(regular(3, 25), 28)


@designed()
def prism30():
    """An acute edge of 30 degrees."""
    height, half = 40, 40 * np.tan(np.radians(15))
    return prism([(-20, -half), (height - 20, 0), (-20, half)], 26)


@designed()
def slots():
    """Slots 1.5, 2, 3, 4 and 6 cells wide in a block, six cells apart."""
    solid = box(48, 26, 24)
    at = -20.5
    for width in (1.5, 2, 3, 4, 6):
        solid -= box(width, 40, 14).translate((at + width / 2, 0, 8))
        at += width + 6
    return solid


@designed()
def walls():
    """Walls 1.5, 2, 3, 4 and 6 cells thick on a plate, six cells apart."""
    solid = box(48, 26, 8).translate((0, 0, -10))
    at = -20.5
    for width in (1.5, 2, 3, 4, 6):
        solid += box(width, 22, 22).translate((at + width / 2, 0, 3))
        at += width + 6
    return solid


@designed()
def fillets():
    """A block with fillets of radius 1, 2, 4 and 8 along its four long edges."""
    x, y, angles = 18, 14, np.linspace(0, np.pi / 2, 65)
    outline, rounds = [], []
    signs = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    for k, ((sx, sy), radius) in enumerate(zip(signs, (1, 2, 4, 8))):
        centre = np.array([sx * (x - radius), sy * (y - radius)])
        turn = angles + k * np.pi / 2
        outline.append(centre + radius * np.stack([np.cos(turn), np.sin(turn)], axis=1))
        rounds.append(surfaces.cylinder(radius, centre))
    section = CrossSection([np.vstack(outline)])
    return primitives.primitive(Manifold.extrude(section, 32).translate((0, 0, -16)), *rounds)


@designed()
def cone_tip():
    """A tip without an edge, and a circular rim."""
    return cone(20, 0, 36).translate((0, 0, -16))


@designed()
def frustum():
    """An obtuse and an acute circular rim."""
    return cone(22, 12, 26).translate((0, 0, -13))


@designed()
def capped_cylinder():
    """Two circular rims of 90 degrees."""
    return cylinder(16, 34)


@designed()
def torus_plain():
    """No edge anywhere: nothing may change."""
    return torus(18, 8)


@designed()
def bumpy_sphere():
    """Free form without an edge: nothing may change."""
    return _bumpy(20, 0.06)


@designed()
def ball_cut():
    """A sphere cut by two cylinders: edges curved in space, two corners."""
    ball = sphere(22) - cylinder(9, 60).rotate((90, 0, 0)).translate((4, 0, 3))
    return ball - cylinder(10, 60).translate((17, -13, 0))


@designed()
def dome():
    """A cylinder under a spherical cap that does not meet it tangentially; a shallow circle."""
    return cylinder(16, 60).translate((0, 0, 14)) ^ sphere(24).translate((0, 0, -2))


@designed()
def lens():
    """Two spheres: one acute circular edge and nothing else."""
    return sphere(27).translate((0, 0, 13)) ^ sphere(27).translate((0, 0, -13))


@designed()
def tee():
    """Two pipes joined: a concave curved edge whose angle changes along it."""
    return cylinder(13, 46).rotate((0, 90, 0)) + cylinder(9, 28).translate((3, 0, 14))


@designed()
def knob():
    """A knob with nine cylindrical scallops of radius five."""
    solid = cylinder(20, 18)
    scallops = [cylinder(5, 40).translate((21.5, 0, 0)).rotate((0, 0, 40 * k)) for k in range(9)]
    return solid - joined(scallops)


@designed()
def gear():
    """A hub with ten teeth and a bore: many short edges, convex and concave."""
    solid = cylinder(15, 14)
    teeth = [box(14, 5, 14).translate((16, 0, 0)).rotate((0, 0, 36 * k)) for k in range(10)]
    return solid + joined(teeth) - cylinder(6, 30)


@designed()
def csg():
    """The classic: a box and a sphere intersected, minus three cylinders."""
    solid = box(34, 34, 34) ^ sphere(22.5)
    for angles in ((0, 0, 0), (90, 0, 0), (0, 90, 0)):
        solid -= cylinder(9, 60).rotate(angles)
    return solid


@designed()
def fading():
    """A ridge on a block that fades from 104 degrees between its sides into a flat face."""
    return _fading_ridge()


@designed()
def octahedron():
    """Corners of valence four and edges of 109 degrees."""
    return primitives.hull(24 * np.vstack([np.eye(3), -np.eye(3)]))


def _bumpy(radius, height):
    """A sphere whose radius varies by a smooth pattern."""
    ball = Manifold.sphere(1, int(1.4 * primitives.segments(radius))).to_mesh64()
    directions = surfaces.unit(np.array(ball.vert_properties[:, :3], dtype=float))
    frequency = 4.0

    def pattern(d):
        return np.sin(frequency * d[:, 0]) * np.sin(frequency * d[:, 1] + 1) \
            + np.sin(frequency * d[:, 2] + 2)

    def pattern_gradient(d):
        x, y, z = frequency * d.T + np.array([[0], [1], [2]])
        return frequency * np.stack([np.cos(x) * np.sin(y), np.sin(x) * np.cos(y), np.cos(z)], 1)

    def gradient(p):
        """Of |p| - radius (1 + height pattern(p / |p|))."""
        length = np.linalg.norm(p, axis=1, keepdims=True)
        d = p / length
        g = pattern_gradient(d)
        tangential = g - (g * d).sum(axis=1, keepdims=True) * d
        return d - radius * height * tangential / length

    points = directions * radius * (1 + height * pattern(directions))[:, None]
    mesh = Mesh64(np.ascontiguousarray(points), np.array(ball.tri_verts, dtype=np.uint64))
    return primitives.primitive(Manifold(mesh), surfaces.level_set(gradient, 5))


def _fading_ridge():
    """A block whose top is z = 6 - |y| f(x), with f falling smoothly from tan 38 deg to zero."""
    half_x, half_y, steep = 22.0, 15.0, np.tan(np.radians(38))
    angle = np.pi / (2 * half_x)

    def profile(x):
        return steep * (1 - np.sin(angle * x)) / 2

    def side(sign):
        def gradient(p):
            """Zero on the other side of the ridge, so that no facet there is taken for this one."""
            slope = -steep * angle * np.cos(angle * p[:, 0]) / 2
            g = np.stack([sign * p[:, 1] * slope, sign * profile(p[:, 0]), np.ones(len(p))], 1)
            return g * (sign * p[:, 1:2] > -1e-6)
        return surfaces.level_set(gradient, 20)

    x = np.linspace(-half_x, half_x, 177)
    y = np.concatenate([np.linspace(-half_y, 0, 61), np.linspace(0, half_y, 61)[1:]])
    grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1)
    top = np.dstack([grid, 6 - np.abs(grid[..., 1]) * profile(grid[..., 0])])
    low = np.dstack([grid, np.full(grid.shape[:2], -14.0)])
    return primitives.primitive(_between(top, low), side(-1), side(1))


def _between(top, low):
    """The solid between two height fields over one grid."""
    nx, ny = top.shape[:2]
    ids = np.arange(nx * ny).reshape(nx, ny)
    a, b = ids[:-1, :-1].ravel(), ids[1:, :-1].ravel()
    c, d = ids[1:, 1:].ravel(), ids[:-1, 1:].ravel()
    upper = np.vstack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    lower = upper[:, ::-1] + nx * ny
    rim = np.concatenate([ids[:-1, 0], ids[-1, :-1], ids[:0:-1, -1], ids[0, :0:-1]])
    after = np.roll(rim, -1)
    wall = np.vstack([np.stack([rim, rim + nx * ny, after + nx * ny], 1),
                      np.stack([rim, after + nx * ny, after], 1)])
    tris = np.ascontiguousarray(np.vstack([upper, lower, wall]), dtype=np.uint64)
    points = np.ascontiguousarray(np.vstack([top.reshape(-1, 3), low.reshape(-1, 3)]))
    return Manifold(Mesh64(points, tris))
