"""The surfaces between several materials, contoured: exact along the edges of a grid of tetrahedra."""

from itertools import combinations, permutations

import numpy as np

from meshes import Mesh

# Six tetrahedra fill a cell: each follows the axes in another order from its lowest corner on.
_PATHS = [np.cumsum([(0, 0, 0), *np.eye(3, dtype=int)[list(order)]], axis=0)
          for order in permutations(range(3))]


def interfaces(inside, half, resolution):
    """A mesh and the patch ids of its triangles: those of pairs of materials.

    `inside` has one array a material, of values at the grid's points, positive where it is; the
    cube from -half to half has `resolution` cells a side. Within a tetrahedron values are linear.
    Two materials meet in a triangle or quadrangle; where there are more, they meet in triangles
    around the point where three (or all four) are alike.
    """
    inside = np.stack(inside)
    count = resolution + 1
    values = inside.reshape(len(inside), -1)
    label = values.argmax(axis=0)
    builder = _Builder(values, label)
    starts = np.stack(np.meshgrid(*[np.arange(resolution)] * 3, indexing="ij"), -1).reshape(-1, 3)
    place = np.array([count * count, count, 1])
    for path in _PATHS:
        tets = (starts[:, None, :] + path[None]) @ place
        for tet in tets[(label[tets] != label[tets[:, :1]]).any(axis=1)]:
            builder.add(tuple(int(v) for v in tet))
    grid = np.stack(np.meshgrid(*[np.linspace(-half, half, count)] * 3, indexing="ij"), -1)
    return builder.mesh(grid.reshape(-1, 3))


class _Builder:
    """Collects the faces of one tetrahedron after the other. A point is a mean of grid points."""

    def __init__(self, values, label):
        self.values, self.label = values, label
        self.numbers, self.means = {}, []
        self.tris, self.ids = [], []

    def add(self, tet):
        """The faces in one tetrahedron of several materials."""
        label = self.label
        kinds = {label[v] for v in tet}
        if len(kinds) == 2:
            one = [v for v in tet if label[v] == min(kinds)]
            two = [v for v in tet if label[v] != min(kinds)]
            if len(one) == 2:
                (a, b), (c, d) = one, two
                loop = [self._point(pair) for pair in ((a, c), (a, d), (b, d), (b, c))]
            else:
                loop = [self._point((a, c)) for a in one for c in two]
            for k in range(1, len(loop) - 1):
                self._triangle((loop[0], loop[k], loop[k + 1]), kinds)
            return
        middle = self._point(tet)
        for face in combinations(tet, 3):
            pairs = [pair for pair in combinations(face, 2) if label[pair[0]] != label[pair[1]]]
            if len(pairs) == 2:
                self._triangle((*map(self._point, pairs), middle), {label[v] for v in face})
            for pair in pairs if len(pairs) == 3 else ():
                self._triangle((self._point(pair), self._point(face), middle),
                               {label[v] for v in pair})

    def _triangle(self, points, kinds):
        self.tris.append(points)
        self.ids.append(min(kinds) * len(self.values) + max(kinds))

    def _point(self, corners):
        """The number of the point where all materials of the corners are alike."""
        corners = tuple(sorted(corners))
        if corners not in self.numbers:
            self.numbers[corners] = len(self.means)
            self.means.append((corners, self._weights(corners)))
        return self.numbers[corners]

    def _weights(self, corners):
        kinds = list(dict.fromkeys(self.label[v] for v in corners))
        values = self.values[np.ix_(kinds, corners)]
        rows = np.vstack([np.ones(len(corners)), values[1:] - values[0]])
        right = np.zeros(len(rows))
        right[0] = 1
        if len(kinds) == len(corners):
            weights = np.linalg.solve(rows, right)
        else:  # three materials at four corners: the middle of the line on which they are alike
            ends = []
            for lone in (v for v in corners if
                         sum(self.label[v] == self.label[w] for w in corners) == 2):
                face = [k for k, v in enumerate(corners) if v != lone]
                end = np.zeros(len(corners))
                end[face] = self._weights(tuple(corners[k] for k in face))
                ends.append(end)
            weights = np.mean(ends, axis=0)
        # Where the values are not linear another material may be ahead there.
        return weights if (weights >= 0).all() else np.full(len(corners), 1 / len(corners))

    def mesh(self, grid):
        """The mesh of all faces, and their ids."""
        points = np.array([weights @ grid[list(corners)] for corners, weights in self.means])
        return Mesh(points, np.array(self.tris)), np.array(self.ids)
