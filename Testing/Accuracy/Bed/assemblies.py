"""Assemblies whose truth is known: materials that touch, open shells, a strip with one side.

`ASSEMBLIES[name]()` makes an Assembly: its exact surface, the curves on it, and what samples it. The
unit of length is one cell of the 64^3 grid, as for the solids.
"""

from dataclasses import dataclass, field

import numpy as np

import nets
import sampling
import tets
from collapse import without_short_edges
from meshes import Locator, Mesh
from primitives import box, cylinder, hull, sphere
from truth import Truth, corners_of

SAME = 1e-3  # cells: curves and surfaces nearer than this are one
SHORT = 0.5  # cells: shorter edges of contours of tetrahedra are taken out
SAMPLED_STRIP = 1.0  # cells: edges of the strip with one side


@dataclass
class Assembly:
    """Surfaces and curves to measure against; `sampled(kind, resolution)` gives a mesh and patch ids."""

    mesh: Mesh
    points: np.ndarray  # of the curves
    sharp: np.ndarray  # segments: inside patches, where these have edges, and along junctions
    faint: np.ndarray  # the same with those that need not be found
    junctions: np.ndarray  # segments where three patches or more meet
    free: np.ndarray  # segments of free boundaries
    sampled: callable
    corners: np.ndarray = field(init=False)
    valences: np.ndarray = field(init=False)

    def __post_init__(self):
        """Corners are where curves of any kind meet or turn."""
        curves = np.vstack([self.sharp, self.free])
        self.corners, self.valences = corners_of(*_welded(self.points, curves))
        self.locator = Locator(self.mesh.points, self.mesh.tris)


ASSEMBLIES = {}  # name -> function that makes it


def assembly(function):
    """Registers a function."""
    ASSEMBLIES[function.__name__] = function
    return function


@assembly
def cube_in_cube():
    """A cube let into another, one face flush with it."""
    outer, inner = box(36, 34, 32), box(16, 16, 14).translate((2, -3, 9))
    return of_materials(outer, [outer - inner, inner])


@assembly
def two_cubes_and_sphere():
    """The paper's first example: two cubes through each other, and a sphere through both.

    Examples/Python/recover_assembly.py has the same.
    """
    one = box(26, 26, 26).translate((-5, -4, -3))
    two = box(24, 24, 24).rotate((24, 31, 40)).translate((8, 7, 5))
    ball = sphere(13).translate((5, -12, 8))
    return of_materials(one + two + ball, [one, two - one, ball - one - two])


@assembly
def four_materials():
    """A block of four materials that meet in one point."""
    block = box(34, 32, 30)
    seeds = 9.0 * np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], dtype=float)
    parts, far = [], 200.0
    for own in range(len(seeds)):
        part = block
        for other in set(range(len(seeds))) - {own}:
            part ^= half_space(seeds[own] - seeds[other], far)
        parts.append(part)
    return of_materials(block, parts)


@assembly
def layered_plates():
    """Plates of three thicknesses on each other, a bolt through all of them."""
    bolt = cylinder(6, 18)
    plates = [box(38, 30, height).translate((0, 0, low + height / 2)) - bolt
              for low, height in ((-9, 4), (-5, 6), (1, 8))]
    return of_materials(box(38, 30, 18), [*plates, bolt])


@assembly
def open_shells():
    """Two halves of a block with a bore, cut apart by a plane; all points there are doubled."""
    solid = box(34, 28, 24) - cylinder(7, 40)
    return _halves(solid, both=True)


@assembly
def half_shell():
    """One half of the same: a mesh with a free boundary that edges run into."""
    return _halves(box(34, 28, 24) - cylinder(7, 40), both=False)


@assembly
def one_sided_strip():
    """A strip with one side, with two creases."""
    return _strip()


def _turned(solid):
    return solid.rotate((22, 37, 48)).translate((0.3, -0.2, 0.1))


def half_space(normal, far):
    """A large box on the side of the plane through the origin that `normal` points to."""
    normal = normal / np.linalg.norm(normal)
    u = np.cross(normal, (0.3, 0.5, 0.8))
    u /= np.linalg.norm(u)
    w = np.cross(normal, u)
    corners = [s * far * u + t * far * w + d * far * normal
               for s in (-1, 1) for t in (-1, 1) for d in (0, 1)]
    return hull(corners)


def _welded(points, segments):
    """Points that are one, as one."""
    _, first, index = np.unique(points.round(6), axis=0, return_index=True, return_inverse=True)
    segments = index.reshape(-1)[segments]
    segments = np.unique(np.sort(segments, axis=1), axis=0)
    return points[first], segments[segments[:, 0] != segments[:, 1]]


def _stacked(truths, which):
    """The points of all truths and the segments of one kind on them."""
    offsets = np.cumsum([0, *(len(t.mesh.points) for t in truths)])
    segments = np.vstack([getattr(t, which) + o for t, o in zip(truths, offsets)])
    return np.vstack([t.mesh.points for t in truths]), segments


def of_materials(everything, solids):
    """Solids that fill parts of another; what is outside that is one more material."""
    truths = [Truth(_turned(solid)) for solid in [everything, *solids]]
    points, sharp = _welded(*_stacked(truths, "segments"))
    faint_points, faint = _welded(*_stacked(truths, "faint_segments"))
    middles = points[sharp].mean(axis=1)
    touching = sum((t.locator.closest(middles)[0] < SAME).astype(int) for t in truths)
    offsets = np.cumsum([0, *(len(t.mesh.points) for t in truths)])
    surface = Mesh(np.vstack([t.mesh.points for t in truths]),
                   np.vstack([t.mesh.tris + o for t, o in zip(truths, offsets)]))

    def sampled(kind, resolution):
        inside = [-sampling.distances(truth, resolution, band=3) for truth in truths]
        inside[0] = -inside[0]
        if kind == "nets":
            return nets.interfaces(inside, sampling.HALF, resolution)
        mesh, ids = tets.interfaces(inside, sampling.HALF, resolution)
        return without_short_edges(mesh, ids, SHORT * 2 * sampling.HALF / resolution)

    return Assembly(surface, np.vstack([points, faint_points]), sharp, faint + len(points),
                    sharp[touching >= 3], np.zeros((0, 2), dtype=int), sampled)


def _halves(solid, both):
    """A closed surface cut by a plane: one half of it, or both, appended to each other."""
    truth = Truth(_turned(solid))
    normal, level = np.array([0.25, 0.35, 0.9]), 0.8
    normal /= np.linalg.norm(normal)
    height = truth.mesh.points @ normal - level
    rim_points, rim = nets.plane_cut(truth.mesh.points, truth.mesh.tris, height)
    points = truth.mesh.points
    if both:
        keep, tris = truth.segments, truth.mesh.tris
        faint, free = truth.faint_segments, np.zeros((0, 2), dtype=int)
    else:
        points, keep = nets.clip_segments(truth.mesh.points, truth.segments, normal, level)
        faint = keep
        tris = truth.mesh.tris[(height[truth.mesh.tris] < 0.5).all(axis=1)]
        free = rim + len(points)
        points = np.vstack([points, rim_points])

    def sampled(kind, resolution):
        whole = sampling.contour(truth, resolution)
        return nets.cut_apart(whole, normal, level, both)

    return Assembly(Mesh(truth.mesh.points, tris), points, keep, faint,
                    np.zeros((0, 2), dtype=int), free, sampled)


def _strip():
    """A profile of three straight parts, half a turn about its middle for one turn about z."""
    ring, width, side = 22.0, 5.0, 4.0
    knots = np.array([(-width, side), (-width / 2, 0), (width / 2, 0), (width, -side)])
    lengths = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(knots, axis=0), axis=1))])

    def surface(u, s):
        """Positions for the angle u and the way s across."""
        x = np.interp(s, lengths, knots[:, 0])
        y = np.interp(s, lengths, knots[:, 1])
        out = x * np.cos(u / 2) - y * np.sin(u / 2)
        up = x * np.sin(u / 2) + y * np.cos(u / 2)
        return np.stack([(ring + out) * np.cos(u), (ring + out) * np.sin(u), up], axis=-1)

    def grid(around, ways, jitter=0.0):
        """Triangles of a grid whose last column goes over into the first, turned over."""
        rng = np.random.default_rng(sampling.SEED)
        u, s = np.meshgrid(2 * np.pi * np.arange(around) / around, ways, indexing="ij")
        if jitter:
            inner = slice(1, len(ways) - 1)
            s[:, inner] += rng.uniform(-jitter, jitter, s[:, inner].shape) * np.diff(ways).min()
            u += rng.uniform(-jitter, jitter, u.shape) * 2 * np.pi / around
        tris = []
        for i in range(around):
            here = np.arange(len(ways)) + i * len(ways)
            there = here + len(ways) if i + 1 < around else np.arange(len(ways))[::-1]
            for k in range(len(ways) - 1):
                a, b, c, d = here[k], there[k], there[k + 1], here[k + 1]
                tris += [(a, b, c), (a, c, d)] if (i + k) % 2 else [(a, b, d), (b, c, d)]
        return Mesh(surface(u.ravel(), s.ravel()), np.array(tris))

    fine = grid(720, np.unique(np.concatenate([np.linspace(0, lengths[-1], 60), lengths])))
    turn = np.linspace(0, 2 * np.pi, 721)

    def curve(way):
        points = surface(turn, np.full(len(turn), way))
        first = np.arange(len(turn) - 1)
        return points, np.stack([first, first + 1], axis=1)

    points, segments = zip(*(curve(way) for way in lengths))
    offset = len(turn)
    points = np.vstack(points)
    sharp = np.vstack([segments[k] + k * offset for k in (1, 2)])
    free = np.vstack([segments[k] + k * offset for k in (0, 3)])

    def sampled(kind, resolution):
        cell = SAMPLED_STRIP * 64 / resolution
        across = int(round(lengths[-1] / cell))
        ways = np.linspace(0, lengths[-1], across + 1)
        mesh = grid(int(round(2 * np.pi * ring / cell)), ways, 0.3)
        flip = np.random.default_rng(sampling.SEED).random(len(mesh.tris)) < 0.5
        mesh.tris[flip] = mesh.tris[flip][:, [0, 2, 1]]
        return mesh, None

    return Assembly(fine, points, sharp, sharp, np.zeros((0, 2), dtype=int), free, sampled)
