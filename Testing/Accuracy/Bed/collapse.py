"""Takes the short edges out of a mesh of patches; no vertex is moved, some are left out."""

import numpy as np

from meshes import Mesh

LEAST_COSINE = 0.5  # between the normals of a triangle before and after
LEAST_HEIGHT = 0.05  # of a triangle, in the length of what is short


def without_short_edges(mesh, ids, short):
    """The mesh and ids without edges shorter than `short`, as far as nothing turns over.

    A vertex goes to the other end of an edge if that is in all of its patches, and along junctions
    only if the edge is one; what is connected how stays.
    """
    work = _Collapser(mesh, ids, short)
    while work.run_once():
        pass
    return work.result()


class _Collapser:
    def __init__(self, mesh, ids, short):
        self.points, self.short = mesh.points, short
        self.tris = [tuple(int(v) for v in tri) for tri in mesh.tris]
        self.ids = list(ids)
        self.around = [set() for _ in mesh.points]
        for t, tri in enumerate(self.tris):
            for v in tri:
                self.around[v].add(t)

    def run_once(self):
        """Tries all short edges, the shortest first; whether anything went."""
        edges = {(min(a, b), max(a, b)) for tri in self.tris if tri
                 for a, b in zip(tri, tri[1:] + tri[:1])}
        edges = np.array(sorted(edges))
        length = np.linalg.norm(self.points[edges[:, 0]] - self.points[edges[:, 1]], axis=1)
        order = np.argsort(length, kind="stable")
        changed = False
        for a, b in edges[order[length[order] < self.short]].tolist():
            if self.around[a] & self.around[b]:
                changed |= self._collapse(a, b) or self._collapse(b, a)
        return changed

    def _kinds(self, triangles):
        return {self.ids[t] for t in triangles}

    def _collapse(self, goes, stays):
        """Moves one vertex onto another; False if it may not."""
        both = self.around[goes] & self.around[stays]
        kinds = self._kinds(self.around[goes])
        if kinds != self._kinds(both) or self._neighbours(goes) & self._neighbours(stays) != {
                v for t in both for v in self.tris[t]} - {goes, stays}:
            return False
        others = self.around[goes] - both
        moved = {t: tuple(stays if v == goes else v for v in self.tris[t]) for t in others}
        if not all(self._is_like(self.tris[t], tri) for t, tri in moved.items()):
            return False
        for t in both:
            for v in self.tris[t]:
                self.around[v].discard(t)
            self.tris[t] = None
        for t, tri in moved.items():
            self.tris[t] = tri
            self.around[goes].discard(t)
            self.around[stays].add(t)
        return True

    def _neighbours(self, vertex):
        return {v for t in self.around[vertex] for v in self.tris[t]} - {vertex}

    def _is_like(self, before, after):
        one, two = self._cross(before), self._cross(after)
        size, longest = np.linalg.norm(two), self._longest(after)
        return size > LEAST_HEIGHT * self.short * longest and \
            one @ two >= LEAST_COSINE * np.linalg.norm(one) * size

    def _cross(self, tri):
        a, b, c = self.points[list(tri)]
        return np.cross(b - a, c - a)

    def _longest(self, tri):
        a, b, c = self.points[list(tri)]
        return max(np.linalg.norm(b - a), np.linalg.norm(c - b), np.linalg.norm(a - c))

    def result(self):
        """What is left."""
        left = [t for t, tri in enumerate(self.tris) if tri]
        used, tris = np.unique([self.tris[t] for t in left], return_inverse=True)
        return Mesh(self.points[used], tris.reshape(-1, 3)), np.array([self.ids[t] for t in left])
