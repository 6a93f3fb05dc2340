"""The exact solid to measure against: a fine surface, its sharp curves, its corners and tips.

A Truth is made from a solid of `primitives` that the kernel has joined and cut. Sharp curves are
the edges between facets of *different* smooth surfaces whose exact normals differ there, so neither
facets of curved faces nor coplanar faces of joined parts are ever taken for edges.
"""

import numpy as np
from scipy.spatial import cKDTree

import primitives
from meshes import Locator, Mesh
from surfaces import Placed

SHARP = 20.0  # degrees between exact normals from which on an edge is sharp and has to be found
FAINT = 10.0  # degrees from which on an edge that is found is not a false one
FACET = 2.0  # cells (at 64^3): longest edge of a facet
BALL = 0.3  # cells (at 64^3): a corner is judged by how curves leave a ball of this radius
TURN = 30.0  # degrees a curve turns inside the ball to make a corner of two edges


class Truth:
    """The surface (`mesh`), sharp `segments`, faint ones, `corners` with their `valences`.

    A valence is the number of sharp edges that meet: 3 or more, 2 for a sharp turn of a curve, and
    0 for the tip of a cone.
    """

    def __init__(self, solid):
        kernel_mesh = solid.refine_to_length(FACET).to_mesh64()
        points = np.array(kernel_mesh.vert_properties[:, :3], dtype=np.float64)
        self.mesh = Mesh(points, np.array(kernel_mesh.tri_verts, dtype=np.int64))
        self.surfaces, self.surface_of = _placed_surfaces(kernel_mesh, self.mesh)
        self.locator = Locator(self.mesh.points, self.mesh.tris)
        ends, angles = self._creases()
        self.segments = ends[angles > SHARP]
        self.faint_segments = ends[angles > FAINT]
        self.tips = _tips(kernel_mesh, self.mesh)
        corners, valences = corners_of(self.mesh.points, self.segments)
        self.corners = np.vstack([corners, self.tips])
        self.valences = np.concatenate([valences, np.zeros(len(self.tips), dtype=int)])
        self.curve_locator = Locator(self.mesh.points, self.segments)

    def normals(self, points, tris):
        """The exact outward normals at points of these triangles."""
        return self._by_surface(points, tris, Placed.normals, np.empty((len(points), 3)))

    def radii(self, points, tris):
        """The smallest radius of curvature at points of these triangles."""
        return self._by_surface(points, tris, Placed.radii, np.empty(len(points)))

    def distance_to_features(self, points):
        """The distance from the nearest sharp curve or tip; infinity if there is neither."""
        distance, _, _ = self.curve_locator.closest(points)
        if len(self.tips):
            distance = np.minimum(distance, cKDTree(self.tips).query(points)[0])
        return distance

    def curve_length(self):
        """The length of all sharp curves."""
        a, b = self.mesh.points[self.segments].transpose(1, 0, 2)
        return np.linalg.norm(b - a, axis=1).sum()

    def _by_surface(self, points, tris, question, answers):
        """Asks each point's own smooth surface a question."""
        surface = self.surface_of[tris]
        for k in np.unique(surface):
            mine = surface == k
            answers[mine] = question(self.surfaces[k], points[mine])
        return answers

    def _creases(self):
        """Edges between two smooth surfaces (pairs of points), and the angle at their middles."""
        ends, tris = self.mesh.edges()
        border = self.surface_of[tris[:, 0]] != self.surface_of[tris[:, 1]]
        ends, tris = ends[border], tris[border]
        middle = self.mesh.points[ends].mean(axis=1)
        one, two = self.normals(middle, tris[:, 0]), self.normals(middle, tris[:, 1])
        return ends, np.degrees(np.arccos(np.clip((one * two).sum(axis=1), -1, 1)))


def _runs(kernel_mesh):
    """The parts of a kernel mesh: triangle range, original id, and rigid motion."""
    bounds = np.asarray(kernel_mesh.run_index, dtype=np.int64) // 3
    for k, original in enumerate(kernel_mesh.run_original_id):
        motion = np.asarray(kernel_mesh.run_transform[k], dtype=float)
        yield slice(bounds[k], bounds[k + 1]), int(original), motion[:3], motion[3]


def _placed_surfaces(kernel_mesh, mesh):
    """The smooth surfaces in place, and which one each triangle belongs to."""
    facet_normals, areas = mesh.normals_and_areas()
    centroids = mesh.centroids()
    face = np.asarray(kernel_mesh.face_id, dtype=np.int64)
    placed, surface_of = [], np.full(len(mesh.tris), -1)
    for run, original, rotation, origin in _runs(kernel_mesh):
        for k in np.unique(face[run]):
            mine = np.arange(run.start, run.stop)[face[run] == k]
            surface = Placed(primitives.SURFACES[original][k], rotation, origin, 1.0)
            cosine = (surface.normals(centroids[mine]) * facet_normals[mine]).sum(axis=1)
            inside_out = (areas[mine] * cosine).sum() < 0
            surface_of[mine] = len(placed)
            placed.append(surface._replace(sign=-1.0 if inside_out else 1.0))
    return placed, surface_of


def _tips(kernel_mesh, mesh):
    """The apexes of cones that are still points of the result."""
    tips = [primitives.TIPS[original] @ rotation + origin
            for _, original, rotation, origin in _runs(kernel_mesh)]
    tips = np.unique(np.vstack(tips).round(9), axis=0)
    return tips[cKDTree(mesh.points).query(tips)[0] < 1e-6] if len(tips) else tips


def corners_of(points, segments):
    """Where three or more sharp curves meet, or one turns: positions and valences."""
    ids, local = np.unique(segments, return_inverse=True)
    if not len(ids):
        return np.zeros((0, 3)), np.zeros(0, dtype=int)
    points, segments = points[ids], local.reshape(-1, 2)
    neighbours = [[] for _ in ids]
    for a, b in segments:
        neighbours[a].append(b)
        neighbours[b].append(a)

    candidates = []
    for v, inside in enumerate(cKDTree(points).query_ball_point(points, BALL)):
        directions = _leaving(points, v, set(inside), neighbours)
        valence = len(directions)
        turn = 0.0
        if valence == 2:
            turn = 180 - np.degrees(np.arccos(np.clip(directions[0] @ directions[1], -1, 1)))
        if valence >= 3 or turn > TURN:
            meets = len(neighbours[v]) if valence >= 3 else 0
            candidates.append((valence, meets, turn, v))

    corners, valences = [], []
    for valence, _, _, v in sorted(candidates, reverse=True):
        if all(np.linalg.norm(points[v] - c) > 2 * BALL for c in corners):
            corners.append(points[v])
            valences.append(valence)
    return np.reshape(corners, (-1, 3)), np.array(valences, dtype=int)


def _leaving(points, centre, inside, neighbours):
    """Directions, at least 10 degrees apart, in which curves connected to it leave the ball."""
    reached, stack, directions = {centre}, [centre], []
    while stack:
        v = stack.pop()
        for w in neighbours[v]:
            if w not in inside:
                towards = _on_sphere(points[v] - points[centre], points[w] - points[v])
                if all(towards @ d < np.cos(np.radians(10)) for d in directions):
                    directions.append(towards)
            elif w not in reached:
                reached.add(w)
                stack.append(w)
    return directions


def _on_sphere(start, step):
    """The direction in which start + t step leaves the ball about the origin."""
    a, b, c = step @ step, start @ step, start @ start - BALL**2
    where = start + (np.sqrt(max(b * b - a * c, 0)) - b) / a * step
    return where / np.linalg.norm(where)
